#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/debug_messages.h>
#include <hachure/runtime/gpu/gl_format.h>
#include <hachure/runtime/gpu/texture.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace hachure::gpu {
namespace {

template <typename T>
constexpr GLenum component_type = std::is_same_v<T, float>
                                      ? GL_FLOAT
                                      : (std::is_same_v<T, std::uint8_t> ? GL_UNSIGNED_BYTE : GL_UNSIGNED_INT);

/// Whether pixels of component T are a way to hand over this kind of format.
template <typename T> bool suits(FormatKind kind) {
    if constexpr (std::is_same_v<T, float>) return kind != FormatKind::unsigned_integer;
    if constexpr (std::is_same_v<T, std::uint8_t>) return kind == FormatKind::normalized;
    return kind == FormatKind::unsigned_integer;
}

void check_desc(const TextureDesc& desc, std::string_view label) {
    HACHURE_ASSERT(desc.width >= 1 && desc.height >= 1 && desc.samples >= 1, "a texture has at least one texel");
    HACHURE_ASSERT(desc.levels >= 1 && desc.levels <= mip_levels(desc.width, desc.height),
                   "a texture has from one level to a complete chain");
    HACHURE_ASSERT(desc.samples == 1 || desc.levels == 1, "a multisampled texture has one level");
    const ContextLimits& limits = Context::current()->limits();
    if (desc.width > limits.max_texture_size || desc.height > limits.max_texture_size) {
        throw Error(label, fmt::format("a texture of {}x{} is larger than this device's {}", desc.width, desc.height,
                                       limits.max_texture_size));
    }
    if (desc.samples > 1 && desc.samples > limits.max_samples) {
        throw Error(label, fmt::format("{} samples are more than this device's {}", desc.samples, limits.max_samples));
    }
}

/// Values of one row of a level.
std::size_t row_values(const Texture& texture, int level) {
    return static_cast<std::size_t>(texture.width(level)) * static_cast<std::size_t>(texture.channels());
}

template <typename T> void check_transfer(const Texture& texture, std::size_t values, int level) {
    HACHURE_ASSERT(texture.desc().samples == 1, "pixels of a multisampled texture are resolved first");
    HACHURE_ASSERT(level >= 0 && level < texture.desc().levels, "the texture has no such level");
    HACHURE_ASSERT(suits<T>(gl_format(texture.desc().format).kind), "these pixels do not suit the texture's format");
    HACHURE_ASSERT(values == row_values(texture, level) * static_cast<std::size_t>(texture.height(level)),
                   "the pixels do not have the level's size");
}

template <typename T> void flip_rows(std::span<T> pixels, std::size_t row) {
    const std::size_t rows = pixels.size() / row;
    for (std::size_t y = 0; y < rows / 2; ++y) {
        std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(y * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * row));
    }
}

template <typename T> void upload_level(const Texture& texture, std::span<const T> pixels, RowOrder order, int level) {
    check_transfer<T>(texture, pixels.size(), level);
    std::vector<T> flipped;
    if (order == RowOrder::top_first) {
        flipped.assign(pixels.begin(), pixels.end());
        flip_rows(std::span<T>(flipped), row_values(texture, level));
        pixels = flipped;
    }
    gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl().TextureSubImage2D(texture.name(), level, 0, 0, texture.width(level), texture.height(level),
                           gl_format(texture.desc().format).pixel_format, component_type<T>, pixels.data());
}

template <typename T> void read_level(const Texture& texture, std::span<T> pixels, RowOrder order, int level) {
    check_transfer<T>(texture, pixels.size(), level);
    HACHURE_ASSERT(pixels.size_bytes() <= static_cast<std::size_t>(std::numeric_limits<GLsizei>::max()),
                   "a level of 2 GiB is read in one piece");
    gl().PixelStorei(GL_PACK_ALIGNMENT, 1);
    // It waits for the texture anyway - or should: of one that was only cleared since it was drawn into, llvmpipe 22.3
    // gives what was drawn, every other time on a busy machine.
    gl().Finish();
    gl().GetTextureImage(texture.name(), level, gl_format(texture.desc().format).pixel_format, component_type<T>,
                         static_cast<GLsizei>(pixels.size_bytes()), pixels.data());
    if (order == RowOrder::top_first) flip_rows(pixels, row_values(texture, level));
}

template <typename T> std::vector<T> read_vector(const Texture& texture, RowOrder order, int level) {
    std::vector<T> pixels(row_values(texture, level) * static_cast<std::size_t>(texture.height(level)));
    read_level(texture, std::span<T>(pixels), order, level);
    return pixels;
}

template <typename T> void clear_levels(const Texture& texture, const std::array<T, 4>& value) {
    const GlFormat& format = gl_format(texture.desc().format);
    HACHURE_ASSERT(suits<T>(format.kind), "this value does not suit the texture's format");
    for (int level = 0; level < texture.desc().levels; ++level) {
        gl().ClearTexImage(texture.name(), level, format.pixel_format, component_type<T>, value.data());
    }
}

} // namespace

int mip_levels(int width, int height) {
    int levels = 1;
    for (int side = std::max(width, height); side > 1; side /= 2) ++levels;
    return levels;
}

Texture::Texture(const TextureDesc& desc, std::string_view label) : desc_(desc) {
    check_desc(desc, label);
    const bool multisampled = desc.samples > 1;
    const GlFormat& format = gl_format(desc.format);
    GLuint name = 0;
    gl().CreateTextures(multisampled ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, 1, &name);
    handle_ = detail::Handle<&Texture::destroy>(name);
    label_object(GL_TEXTURE, name, label);
    if (multisampled) {
        gl().TextureStorage2DMultisample(name, desc.samples, format.internal_format, desc.width, desc.height, GL_TRUE);
    } else {
        gl().TextureStorage2D(name, desc.levels, format.internal_format, desc.width, desc.height);
    }
    GLint immutable = GL_FALSE;
    gl().GetTextureParameteriv(name, GL_TEXTURE_IMMUTABLE_FORMAT, &immutable);
    if (immutable == GL_FALSE) {
        throw Error(label, fmt::format("no memory for a {} texture of {}x{}", format.name, desc.width, desc.height));
    }
    const bool filtered = format.kind == FormatKind::normalized || format.kind == FormatKind::floating;
    if (!multisampled) set_sampling(filtered ? Sampling() : Sampling::nearest());
}

void Texture::destroy(GLuint name) { gl().DeleteTextures(1, &name); }

void Texture::upload(std::span<const float> pixels, RowOrder order, int level) {
    upload_level(*this, pixels, order, level);
}

void Texture::upload(std::span<const std::uint8_t> pixels, RowOrder order, int level) {
    upload_level(*this, pixels, order, level);
}

void Texture::upload(std::span<const std::uint32_t> pixels, RowOrder order, int level) {
    upload_level(*this, pixels, order, level);
}

void Texture::clear(const std::array<float, 4>& value) { clear_levels(*this, value); }

void Texture::clear(const std::array<std::uint32_t, 4>& value) { clear_levels(*this, value); }

void Texture::read(std::span<float> pixels, RowOrder order, int level) const {
    read_level(*this, pixels, order, level);
}

void Texture::read(std::span<std::uint8_t> pixels, RowOrder order, int level) const {
    read_level(*this, pixels, order, level);
}

void Texture::read(std::span<std::uint32_t> pixels, RowOrder order, int level) const {
    read_level(*this, pixels, order, level);
}

std::vector<float> Texture::read_floats(RowOrder order, int level) const {
    return read_vector<float>(*this, order, level);
}

std::vector<std::uint8_t> Texture::read_bytes(RowOrder order, int level) const {
    return read_vector<std::uint8_t>(*this, order, level);
}

std::vector<std::uint32_t> Texture::read_uints(RowOrder order, int level) const {
    return read_vector<std::uint32_t>(*this, order, level);
}

void Texture::set_sampling(const Sampling& sampling) {
    HACHURE_ASSERT(desc_.samples == 1, "a multisampled texture is read texel by texel");
    detail::apply_sampling(sampling, name(), gl().TextureParameteri, gl().TextureParameterf);
}

void Texture::generate_mipmaps() { gl().GenerateTextureMipmap(name()); }

void Texture::bind(GLuint unit) const { gl().BindTextureUnit(unit, name()); }

void Texture::bind_image(GLuint unit, GLenum access, int level) const {
    gl().BindImageTexture(unit, name(), level, GL_FALSE, 0, access, gl_format(desc_.format).internal_format);
}

int Texture::width(int level) const { return std::max(desc_.width >> level, 1); }

int Texture::height(int level) const { return std::max(desc_.height >> level, 1); }

int Texture::channels() const { return gl_format(desc_.format).channels; }

} // namespace hachure::gpu
