// A level of a pyramid that is sampled for another.

layout(binding = 0) uniform sampler2D tones;

uniform vec2 first; // middles of the texels that hold tones
uniform vec2 last;

layout(location = 0) out vec4 out_tones;

// At a place in texels; what lies beyond the tones is as at their rim.
vec4 at(vec2 place) { return textureLod(tones, clamp(place, first, last) / vec2(textureSize(tones, 0)), 0.0); }
