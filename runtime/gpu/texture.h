#pragma once

#include <hachure/runtime/gpu/handle.h>
#include <hachure/runtime/gpu/sampler.h>
#include <hachure/runtime/gpu/texture_desc.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace hachure::gpu {

/// Which row of pixels comes first in memory. OpenGL's row 0 is the bottom of the picture; image files and everything
/// outside this folder put the top row first.
enum class RowOrder : std::uint8_t { top_first, bottom_first };

/// A 2D texture with immutable storage, single- or multisampled (glCreateTextures, glTextureStorage2D). Its contents
/// are undefined until written. It is read with linear filtering (nearest for integers and depth), without mipmaps,
/// clamped to the edge, until set_sampling says otherwise.
///
/// Pixels in memory are tightly packed, level_width * level_height * channels values. Floats fit every format but the
/// integer ones (0..1 for normalised formats and depth), bytes fit the 8-bit formats, 32-bit integers the integer ones;
/// another mix is an assertion. Bytes of srgb8_alpha8 are the encoded values, in and out.
class Texture {
public:
    Texture() = default;
    /// Throws Error when the context's limits do not allow `desc`, or the driver has no memory for it.
    explicit Texture(const TextureDesc& desc, std::string_view label);

    /// Replaces a whole level (glTextureSubImage2D).
    void upload(std::span<const float> pixels, RowOrder order = RowOrder::top_first, int level = 0);
    void upload(std::span<const std::uint8_t> pixels, RowOrder order = RowOrder::top_first, int level = 0);
    void upload(std::span<const std::uint32_t> pixels, RowOrder order = RowOrder::top_first, int level = 0);

    /// Sets every texel of every level; channels the format lacks are ignored (glClearTexImage).
    void clear(const std::array<float, 4>& value);
    void clear(const std::array<std::uint32_t, 4>& value);

    /// Waits for the GPU and reads a whole level into `pixels` (glGetTextureImage). Single-sampled textures only.
    void read(std::span<float> pixels, RowOrder order = RowOrder::top_first, int level = 0) const;
    void read(std::span<std::uint8_t> pixels, RowOrder order = RowOrder::top_first, int level = 0) const;
    void read(std::span<std::uint32_t> pixels, RowOrder order = RowOrder::top_first, int level = 0) const;

    /// read() into a vector of the right size.
    [[nodiscard]] std::vector<float> read_floats(RowOrder order = RowOrder::top_first, int level = 0) const;
    [[nodiscard]] std::vector<std::uint8_t> read_bytes(RowOrder order = RowOrder::top_first, int level = 0) const;
    [[nodiscard]] std::vector<std::uint32_t> read_uints(RowOrder order = RowOrder::top_first, int level = 0) const;

    /// How shaders read it where no Sampler is bound (glTextureParameter). Not for multisampled textures.
    void set_sampling(const Sampling& sampling);
    /// Fills levels 1 and up from level 0 (glGenerateTextureMipmap).
    void generate_mipmaps();

    /// As a sampler of a program (glBindTextureUnit).
    void bind(GLuint unit) const;
    /// As an image of a program (glBindImageTexture); `access` is GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE.
    void bind_image(GLuint unit, GLenum access, int level = 0) const;

    [[nodiscard]] const TextureDesc& desc() const { return desc_; }
    [[nodiscard]] int width(int level = 0) const;  ///< texels of a level
    [[nodiscard]] int height(int level = 0) const; ///< texels of a level
    [[nodiscard]] int channels() const;            ///< values of a texel
    [[nodiscard]] GLuint name() const { return handle_.get(); }
    [[nodiscard]] explicit operator bool() const { return name() != 0; }

private:
    static void destroy(GLuint name);

    detail::Handle<&Texture::destroy> handle_;
    TextureDesc desc_;
};

/// The levels of a complete mip chain of a `width` x `height` texture.
[[nodiscard]] int mip_levels(int width, int height);

} // namespace hachure::gpu
