#include <hachure/runtime/assert.h>
#include <hachure/runtime/gpu/gl_format.h>

#include <array>

namespace hachure::gpu {
namespace {

// In the order of gpu::Format.
constexpr std::array<GlFormat, 16> formats = {{
    {"r8", GL_R8, GL_RED, 1, FormatKind::normalized},
    {"rg8", GL_RG8, GL_RG, 2, FormatKind::normalized},
    {"rgba8", GL_RGBA8, GL_RGBA, 4, FormatKind::normalized},
    {"srgb8_alpha8", GL_SRGB8_ALPHA8, GL_RGBA, 4, FormatKind::normalized},
    {"rg16", GL_RG16, GL_RG, 2, FormatKind::normalized},
    {"rgba16", GL_RGBA16, GL_RGBA, 4, FormatKind::normalized},
    {"r16f", GL_R16F, GL_RED, 1, FormatKind::floating},
    {"rg16f", GL_RG16F, GL_RG, 2, FormatKind::floating},
    {"rgba16f", GL_RGBA16F, GL_RGBA, 4, FormatKind::floating},
    {"r32f", GL_R32F, GL_RED, 1, FormatKind::floating},
    {"rg32f", GL_RG32F, GL_RG, 2, FormatKind::floating},
    {"rgba32f", GL_RGBA32F, GL_RGBA, 4, FormatKind::floating},
    {"r32ui", GL_R32UI, GL_RED_INTEGER, 1, FormatKind::unsigned_integer},
    {"rg32ui", GL_RG32UI, GL_RG_INTEGER, 2, FormatKind::unsigned_integer},
    {"depth32f", GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, 1, FormatKind::depth},
    {"depth24", GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, 1, FormatKind::depth},
}};

} // namespace

const GlFormat& gl_format(Format format) {
    const auto index = static_cast<std::size_t>(format);
    HACHURE_ASSERT(index < formats.size(), "a format outside the enumeration");
    return formats[index];
}

} // namespace hachure::gpu
