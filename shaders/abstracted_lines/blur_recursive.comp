#version 450 core
// A Gaussian along rows or columns as a recursive filter of third order, there and back, a line per invocation.
// systems/abstracted_lines/recursive_gaussian.h says what the numbers are.
// Defines: THERE_FORMAT and RESULT_FORMAT of the images; CHANNELS, 2 or 4.
layout(local_size_x = 32) in;

layout(binding = 0) uniform sampler2D tones;
layout(binding = 0, THERE_FORMAT) uniform image2D there;
layout(binding = 1, RESULT_FORMAT) uniform writeonly image2D result;

uniform ivec2 first; // texel that the first line begins with
uniform ivec2 along; // to the next texel of a line
uniform int lines;
uniform int texels; // of a line
uniform float gain;
uniform vec2 keep;
uniform mat3 tail;

#if CHANNELS == 2
#define TONE vec2
#define CHANNELS_OF(texel) texel.rg
#define TEXEL_OF(tone) vec4(tone, 0.0, 1.0)
#else
#define TONE vec4
#define CHANNELS_OF(texel) texel
#define TEXEL_OF(tone) tone
#endif

// How far the result has come, and its last two differences.
struct State {
    TONE y, d, before;
};

void advance(inout State state, TONE tone) {
    TONE d = gain * (tone - state.y) + keep.x * state.d + keep.y * state.before;
    state = State(state.y + d, d, state.d);
}

// Where the way back begins. Beyond the end everything is as the last texel is.
State turned(State state, TONE end) {
    TONE y = state.y - end, d = state.d, before = state.before;
    return State(end + tail[0].x * y + tail[1].x * d + tail[2].x * before,
                 tail[0].y * y + tail[1].y * d + tail[2].y * before,
                 tail[0].z * y + tail[1].z * d + tail[2].z * before);
}

void main() {
    int line = int(gl_GlobalInvocationID.x);
    if (line >= lines) return;
    ivec2 start = first + line * along.yx, last = start + (texels - 1) * along;
    State state = State(CHANNELS_OF(texelFetch(tones, start, 0)), TONE(0.0), TONE(0.0));
    for (ivec2 here = start; here != last + along; here += along) {
        advance(state, CHANNELS_OF(texelFetch(tones, here, 0)));
        imageStore(there, here, TEXEL_OF(state.y));
    }
    state = turned(state, CHANNELS_OF(texelFetch(tones, last, 0)));
    for (ivec2 here = last; here != start - along; here -= along) {
        advance(state, CHANNELS_OF(imageLoad(there, here)));
        imageStore(result, here, TEXEL_OF(state.y));
    }
}
