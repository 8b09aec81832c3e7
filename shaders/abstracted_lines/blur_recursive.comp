#version 450 core
// A Gaussian along rows or columns as a recursive filter of third order, there and back, a line per invocation.
// systems/abstracted_lines/recursive_gaussian.h says what the numbers are.
// Defines: THERE_FORMAT and RESULT_FORMAT of the images.
layout(local_size_x = 32) in;

layout(binding = 0) uniform sampler2D tones;
layout(binding = 0, THERE_FORMAT) uniform image2D there;
layout(binding = 1, RESULT_FORMAT) uniform writeonly image2D result;

uniform ivec2 first; // texel that the first line begins with
uniform ivec2 along; // to the next texel of a line
uniform int lines;
uniform int texels; // of a line
uniform float gain;
uniform vec3 feedback;
uniform mat3 tail;

// Beyond both ends everything is as the last texel is.
void main() {
    int line = int(gl_GlobalInvocationID.x);
    if (line >= lines) return;
    ivec2 start = first + line * along.yx;
    vec4 a = texelFetch(tones, start, 0), b = a, c = a;
    for (int i = 0; i < texels; ++i) {
        ivec2 here = start + i * along;
        vec4 y = gain * texelFetch(tones, here, 0) + feedback.x * a + feedback.y * b + feedback.z * c;
        imageStore(there, here, y);
        c = b, b = a, a = y;
    }
    vec4 end = texelFetch(tones, start + (texels - 1) * along, 0);
    mat3x4 state = mat3x4(a - end, b - end, c - end) * transpose(tail);
    a = state[0] + end, b = state[1] + end, c = state[2] + end;
    for (int i = texels - 1; i >= 0; --i) {
        ivec2 here = start + i * along;
        vec4 y = gain * imageLoad(there, here) + feedback.x * a + feedback.y * b + feedback.z * c;
        imageStore(result, here, y);
        c = b, b = a, a = y;
    }
}
