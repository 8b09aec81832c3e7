// From a sum of stamps to ink: Schlick's tone mapping (section 4.1) with a fixed white point, so that a picture does not
// depend on its darkest place. Include after stamp.glsl.

layout(binding = 5) uniform sampler2D canvas_noise;

uniform float white;       // the sum that is opaque: a footprint's mass times the largest weight
uniform float contrast;    // p
uniform float opacity;
uniform vec3 same_color;
uniform float canvas;      // how much noise takes
uniform vec4 canvas_channel;

vec4 toned(SUM sum, ivec2 here) {
#ifdef SAME_COLOR
    float paint = sum;
#else
    float paint = sum.a;
#endif
    if (!(paint > 0.0)) return vec4(0.0);
    float kept = 1.0;
#ifdef CANVAS
    float noise = dot(canvas_channel, texelFetch(canvas_noise, here, 0));
    kept = 1.0 - canvas * clamp(0.5 + 0.5 * noise, 0.0, 1.0);
#endif
    float held = paint * kept;
    float ink = opacity * min(contrast * held / ((contrast - 1.0) * held + white), 1.0);
#ifdef SAME_COLOR
    return vec4(same_color * ink, ink);
#else
    return vec4(sum.rgb / paint * ink, ink); // a homogeneous scaling of all channels
#endif
}
