// The tone of a surface: how much light it receives, before anything is made of it.
#include "common/lights.glsl"

struct Tone {
    float sum;  // over all lights: 1 where the strongest one falls straight on it alone; more where lights add up
    vec3 color; // of the light that falls there, its strongest channel 1; white where none does
};

// How much of light i arrives at a place: less towards the end of its range (KHR_lights_punctual's window) and between
// the cones of a spot. It does not fall with the square of the distance: tones are relative.
float light_reach(int i, vec3 world) {
    float reach = 1.0;
    vec3 way = lights[i].position.xyz - lights[i].position.w * world;
    float range = lights[i].direction.w;
    if (lights[i].position.w > 0.0 && range > 0.0) {
        float part = dot(way, way) / (range * range);
        reach = clamp(1.0 - part * part, 0.0, 1.0);
    }
    if (lights[i].color.w > 0.0) {
        float cosine = -dot(normalize(way), lights[i].direction.xyz);
        float cone = clamp((cosine - lights[i].cone.y) / (lights[i].cone.x - lights[i].cone.y), 0.0, 1.0);
        reach *= cone * cone;
    }
    return reach;
}

// Lights count with their strongest channel, as they are ranked; each reaches round to where n.l is -wrap.
Tone light_tone(vec3 world, vec3 n, float wrap) {
    const float fade = 0.05; // of a light's colour where little of it falls
    Tone tone = Tone(0.0, vec3(fade));
    for (int i = 0; i < light_count; ++i) {
        vec3 color = lights[i].color.rgb;
        float received = max((dot(n, towards_light(i, world)) + wrap) / (1.0 + wrap), 0.0) * light_reach(i, world);
        tone.sum += max(color.r, max(color.g, color.b)) * received;
        tone.color += color * received;
    }
    tone.color /= max(tone.color.r, max(tone.color.g, tone.color.b));
    return tone;
}
