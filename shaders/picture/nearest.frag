#version 450 core
// What a picture says of surfaces, normals or depth, at the size of the view: that of the texel nearest to the pixel's
// middle, since a mean of two surfaces is none of them.

uniform ivec2 place; // pixel of the view at the picture's lower left corner
uniform vec2 texels; // that a pixel spans

layout(binding = 0) uniform sampler2D source;
layout(location = 0) out vec4 value;

void main() {
    vec2 pixel = floor(gl_FragCoord.xy) - vec2(place);
    ivec2 texel = ivec2(floor((pixel + 0.5) * texels));
    value = texelFetch(source, clamp(texel, ivec2(0), textureSize(source, 0) - 1), 0);
}
