// Where a fragment lies among the stripes, and where from there the stripe is that faces the light (docs/metal.md).
#include "common/constants.glsl"

uniform float stripes_per_unit; // of the coordinate
#ifdef AROUND_AXIS
in vec2 about_axis;
uniform mat4 world_from_entity;
uniform mat3 axis_from_entity;
#else
in float coordinate;
in vec3 world_across;
in float turning;
in float weight;
#ifdef SMOOTH_NORMAL
in vec3 world_smooth_normal;    // without the bumps of the surface: streaks that run over bumps stay together
in float turning_per_metre;     // of that normal, in the object's own metres
in float clarity;               // of where the light's stripe is
uniform float object_size;
#endif
uniform float natural_unit;     // of the coordinate: what a surface can be expected to turn on, in sets
#endif

struct Stripes {
    float x;             // stripes
    float dx, dy;        // how far it changes from pixel to pixel
    float weight;        // how much of the pattern is drawn
    float towards_light; // stripes from here to the one that faces the light
    float turn;          // stripes in a whole turn of the surface
    vec2 light;          // the light's direction across the streaks, in the plane of angles
    float bend;          // how the surface lies or turns, as light_weight() below reads it
    float clarity;       // of where the light's stripe is
};

// The light's stripe fades out where the light shines along the streaks, which then face it alike: `across` is the
// length of its direction's share across them.
float faces_across(float across) { return smoothstep(0.0, 0.25, across); }

vec3 normalize_or_zero(vec3 v) {
    float square = dot(v, v);
    return square > 1e-30 ? v * inversesqrt(square) : vec3(0.0);
}

#ifdef AROUND_AXIS
Stripes stripes_here(vec3 n, vec3 l) {
    Stripes s;
    s.turn = stripes_per_unit;
    float scale = stripes_per_unit / (2.0 * PI), square = max(dot(about_axis, about_axis), 1e-30);
    // The derivative of the angle, from those of the place: the angle itself jumps where it begins anew.
    vec2 turned = vec2(-about_axis.y, about_axis.x) / square;
    s.x = scale * atan(about_axis.y, about_axis.x);
    s.dx = scale * abs(dot(turned, dFdx(about_axis)));
    s.dy = scale * abs(dot(turned, dFdy(about_axis)));
    s.weight = 1.0;

    // Normals of the object are the world's times the transposed transform, up to their length: so is what they face.
    vec3 light = length(l) * normalize_or_zero(axis_from_entity * (l * mat3(world_from_entity)));
    vec3 normal = normalize(axis_from_entity * (n * mat3(world_from_entity)));
    float outwards = dot(normal.xy, about_axis * inversesqrt(square));
    float from_light = scale * atan(light.y, light.x) + (outwards < 0.0 ? 0.5 * s.turn : 0.0) - s.x;
    s.towards_light = from_light - s.turn * round(from_light / s.turn);
    s.light = light.xy;
    s.bend = abs(outwards);
    return s;
}

// How much of the light's stripe is drawn. Faces across the axis face the light alike at every angle.
float light_weight(Stripes s) { return faces_across(length(s.light)) * smoothstep(0.0, 0.5, s.bend); }
#else
Stripes stripes_here(vec3 n, vec3 l) {
    Stripes s;
    s.x = stripes_per_unit * coordinate;
    s.dx = abs(dFdx(s.x));
    s.dy = abs(dFdy(s.x));
    s.weight = weight;

    // Seen from behind, the surface turns the other way.
    float side = dot(n, world_normal) < 0.0 ? -1.0 : 1.0;
    float radians = side * turning / stripes_per_unit; // per stripe
#ifdef SMOOTH_NORMAL
    n = side * normalize_or_zero(world_smooth_normal);
#endif
    vec3 across = world_across - dot(world_across, n) * n;
    vec2 light = vec2(dot(across, l) * inversesqrt(max(dot(across, across), 1e-30)), dot(n, l));
    float angle = atan(light.x, light.y);
    float steep = abs(radians) > 1e-9 ? 1.0 / radians : 0.0;
    s.turn = max(2.0 * PI * abs(steep), 1.0);
    s.towards_light = angle * steep;
    s.light = light;
#ifdef SMOOTH_NORMAL
    s.bend = abs(turning_per_metre) * object_size;
    s.clarity = clarity;
#else
    s.bend = abs(turning) * natural_unit;
    s.clarity = 1.0 - smoothstep(15.0, 40.0, s.bend);
#endif
    return s;
}

// How much of the light's stripe is drawn. A surface that hardly turns faces the light alike on many stripes, and white
// would rush across them; one that turns over and over within a unit has no place for it; and from where a bend is turned
// away, both ways round are as long.
float light_weight(Stripes s) {
    float cosine = s.light.y * inversesqrt(max(dot(s.light, s.light), 1e-30));
    return s.weight * faces_across(length(s.light)) * smoothstep(0.6, 1.6, s.bend) *
           s.clarity * smoothstep(-1.0, -0.7071, cosine);
}
#endif
