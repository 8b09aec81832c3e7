// How dark strokes are, in closed form, so that darkness follows delivered shade alone, whatever the distance
// (docs/shade-strokes.md).

uniform float density;  // shade that strokes stand for where they cover the surface, at alpha 1
uniform float darkness; // mean coverage of full shade, over the opacity
uniform float opacity;  // of a stroke at alpha 1

// Ink per area for delivered shade, over that shade. Strokes lie over each other at random: what is left bare by an ink
// of X per area and opacity o is exp(-o X), so a coverage that is linear in shade needs more ink where it is darker.
float ink_of_shade(float shade) {
    float covered = min(opacity * darkness * max(shade, 1e-3), 0.95);
    return -log(1.0 - covered) / (opacity * max(shade, 1e-3));
}

// Mean distance of two random sides in [-1, 1] as neighbouring points have them at t: that of three uniform numbers
// weighted (1 - t) / 2, t and -(1 + t) / 2. It rises from 1/3, half the lines, to 2/3.
float mean_side(float t) { return (1.0 + t + 2.0 * t * t) / (3.0 + 3.0 * t); }

// Mean length of a line whose ends are `away` apart one way and the difference of two uniform numbers in [-1, 1] apart
// the other way: the integral of (1 - x / 2) sqrt(x^2 + away^2) over [0, 2].
float mean_line(float away) {
    if (away > 50.0) return away;
    away = max(away, 1e-4);
    float far = sqrt(4.0 + away * away);
    return far + 0.5 * away * away * asinh(2.0 / away) - (far * far * far - away * away * away) / 6.0;
}

// Mean length of a stroke from point to point, where half the width of the zigzag is `amplitude` and points are `away`
// apart along it.
float mean_stroke(float amplitude, float away, float t) {
    float scale = max(1.5 * mean_side(t) * amplitude, 1e-6);
    return scale * mean_line(away / scale);
}
