#pragma once

#include <hachure/runtime/gpu/texture_desc.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace hachure::gpu {

/// What a frame graph needs of a graphics interface: textures, and a scope with a clock around each pass. A back end
/// outlives the graphs that use it. Called from one thread, with its context current.
class FrameGraphBackend {
public:
    virtual ~FrameGraphBackend() = default;

    /// Makes a texture with undefined contents and returns its id, which is unique among living textures and also
    /// differs from the ids of imported ones. `label` is the first resource that will live in it, for debuggers.
    /// Throws hachure::Error when the driver refuses.
    virtual std::uint32_t create_texture(const TextureDesc& desc, std::string_view label) = 0;

    /// Frees a texture that create_texture() made.
    virtual void destroy_texture(std::uint32_t id) = 0;

    /// Opens a debug group and starts the GPU clock. Passes do not nest. Returns a ticket for gpu_ms(), or 0 when this
    /// pass is not timed.
    virtual std::uint64_t begin_pass(std::string_view name) = 0;

    /// Closes the pass that begin_pass() opened; also called when the pass failed with an exception.
    virtual void end_pass() = 0;

    /// GPU milliseconds of a finished pass, or nothing while the GPU is still at it. Never waits. Asked again in later
    /// frames until it answers, and not after that, so the ticket's resources can then be reused.
    virtual std::optional<double> gpu_ms(std::uint64_t ticket) = 0;

    /// Waits until the GPU has finished every pass, so that gpu_ms() answers for each of them.
    virtual void finish() = 0;
};

} // namespace hachure::gpu
