#version 450 core
// From the gradient of breaks to what can be smoothed without contours of opposite sides, a thin limb's, cancelling out:
// red its length, green and blue the length times cos and sin of twice its angle; alpha 1.
layout(binding = 0) uniform sampler2D breaks;

uniform ivec4 area;

layout(location = 0) out vec4 out_tensor;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 sum = vec2(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            sum += float((2 - abs(x)) * (2 - abs(y))) *
                   texelFetch(breaks, clamp(pixel + ivec2(x, y), area.xy, area.zw), 0).rg;
    sum /= 16.0;
    float size = length(sum);
    vec2 turned = vec2(sum.x * sum.x - sum.y * sum.y, 2.0 * sum.x * sum.y);
    out_tensor = vec4(size, size > 0.0 ? turned / size : vec2(0.0), 1.0);
}
