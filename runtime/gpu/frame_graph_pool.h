#pragma once

#include <hachure/runtime/gpu/frame_graph_backend.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace hachure::gpu::detail {

/// The physical textures of a graph. A texture that is not in use is handed out again for an equal desc, and destroyed
/// after some frames without use. Owns them: the destructor destroys all.
class TexturePool {
public:
    explicit TexturePool(FrameGraphBackend& backend) : backend_(&backend) {}
    ~TexturePool();
    TexturePool(const TexturePool&) = delete;
    TexturePool& operator=(const TexturePool&) = delete;

    /// An idle texture of this desc or a new one; its contents are undefined. Throws what the back end throws.
    std::uint32_t acquire(const TextureDesc& desc, std::string_view label);

    /// Gives back a texture that acquire() returned.
    void release(std::uint32_t id);

    /// Ends a frame: destroys what has been idle for `idle_frames` frames.
    void end_frame(std::uint32_t idle_frames);

    [[nodiscard]] std::size_t count() const { return slots_.size(); }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

private:
    struct Slot {
        std::uint32_t id = 0;
        TextureDesc desc;
        bool in_use = false;
        std::uint32_t idle = 0; ///< whole frames without use
    };

    FrameGraphBackend* backend_;
    std::vector<Slot> slots_;
    std::size_t bytes_ = 0;
};

} // namespace hachure::gpu::detail
