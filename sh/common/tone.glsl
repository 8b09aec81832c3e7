// The tone of a surface: how much light it receives, before anything is made of it.
#include "common/lights.glsl"

struct Tone {
    float sum;  // over all lights: 1 where the strongest one falls straight on it alone; more where lights add up
    vec3 color; // of the light that falls there, its strongest channel 1; white where none does
};

// Lights count with their strongest channel, as they are ranked; each reaches round to where n.l is -wrap.
Tone light_tone(vec3 world, vec3 n, float wrap) {
    const float fade = 0.05; // of a light's colour where little of it falls
    Tone tone = Tone(0.0, vec3(fade));
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 color = lights[i].color.rgb;
        float received = max((dot(n, towards_light(i, world)) + wrap) / (1.0 + wrap), 0.0) * light_reach(i, world);
        tone.sum += max(color.r, max(color.g, color.b)) * received;
        tone.color += color * received;
    }
    tone.color /= max(tone.color.r, max(tone.color.g, tone.color.b));
    return tone;
}
