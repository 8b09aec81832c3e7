#pragma once

#include <cstdint>

namespace hachure::gpu {

namespace detail {
class FrameDeclaration;
}

/// One version of one texture of the frame graph, valid in the frame and graph that made it. Every pass that writes a
/// texture makes a new version, so a handle says which contents are meant and not only which texture. Cheap to copy.
class TextureHandle {
public:
    /// Names no texture; FrameGraph::find() returns it for an unknown name.
    TextureHandle() = default;

    /// Whether it names a texture.
    [[nodiscard]] explicit operator bool() const { return stamp_ != 0; }

    /// How many passes had written the texture when these contents were made: 1 after its creation, 0 for an imported
    /// texture that no pass has written.
    [[nodiscard]] std::uint32_t version() const { return version_; }

    friend bool operator==(const TextureHandle&, const TextureHandle&) = default;

private:
    friend class detail::FrameDeclaration;
    TextureHandle(std::uint32_t texture, std::uint32_t version, std::uint32_t stamp)
        : texture_(texture), version_(version), stamp_(stamp) {}

    std::uint32_t texture_ = 0;
    std::uint32_t version_ = 0;
    std::uint32_t stamp_ = 0; ///< tells frames and graphs apart; 0 in the empty handle
};

} // namespace hachure::gpu
