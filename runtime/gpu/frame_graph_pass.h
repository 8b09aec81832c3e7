#pragma once

#include <hachure/runtime/gpu/frame_graph_handle.h>
#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/runtime/gpu/texture_desc.h>

#include <cstdint>
#include <string_view>
#include <utility>

namespace hachure::gpu {

/// A pass says in its setup what it will use; anything else is refused when it executes. Every function throws
/// FrameGraphError for a wrong declaration. Lives as long as the setup.
class PassBuilder {
public:
    /// A new texture that this pass writes first; version 1 of it. Its contents are undefined, so the pass clears or
    /// covers all of it. The name is unique in the frame and, over frames, the identity under which results are kept.
    TextureHandle create(std::string_view name, const TextureDesc& desc);

    /// The pass samples this version, which must be the newest. Returns the handle.
    TextureHandle read(TextureHandle handle);

    /// The pass writes onto this version, which must be the newest, and sees its contents (blending, depth test).
    /// Returns the next version; the one handed in can no longer be read by passes declared later. A pass does not both
    /// read() and write() a texture.
    TextureHandle write(TextureHandle handle);

    /// The pass depends on these values and on the textures it uses, and on nothing else: while they stay the same, its
    /// results stand and it is not executed. Any number of calls; numbers, enums, strings, spans of numbers, glm
    /// vectors, matrices and rectangles. A pass that never calls this runs in every frame that needs it. Values that a
    /// pass reads at execution time must be among them.
    template <class... T> void depends_on(const T&... values) {
        KeyHash& hash = keys();
        (hash.add(values), ...);
    }

    /// The pass does something besides writing textures (a readback, a file): it is not culled. With depends_on() it
    /// does so again when a value or a texture has changed.
    void side_effect();

    /// Pixels that the pass will cover, for the statistics (see PassStats::pixels).
    void covers(std::uint64_t pixels);

    /// The pass draws in this rectangle alone: what it makes depends on it, and it covers its pixels.
    void draws_in(const Rect& rect) {
        depends_on(rect);
        covers(static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height));
    }

private:
    friend class FrameGraph;
    PassBuilder(detail::FrameDeclaration& frame, std::uint32_t pass) : frame_(&frame), pass_(pass) {}

    /// The hash of this pass's keys; calling it makes the pass one whose results are kept.
    KeyHash& keys();

    detail::FrameDeclaration* frame_;
    std::uint32_t pass_;
};

/// What a pass sees while it executes: the textures it declared, and no others.
class PassContext {
public:
    /// The back end's id of a texture that this pass declared; for an imported one, the id it came with. Throws
    /// FrameGraphError for any other handle, also for another version of a declared texture.
    [[nodiscard]] std::uint32_t texture(TextureHandle handle) const;

    /// The shape of a texture that this pass declared; errors as texture().
    [[nodiscard]] const TextureDesc& desc(TextureHandle handle) const;

    /// Replaces the declared number of covered pixels by the one that came out.
    void set_pixels(std::uint64_t pixels) { pixels_ = pixels; }

private:
    friend class FrameGraph;
    PassContext(const detail::FrameDeclaration& frame, std::uint32_t pass, std::uint64_t pixels)
        : frame_(&frame), pass_(pass), pixels_(pixels) {}

    const detail::FrameDeclaration* frame_;
    std::uint32_t pass_;
    std::uint64_t pixels_;
};

namespace detail {

/// The execute function of a pass with its data.
class PassBody {
public:
    virtual ~PassBody() = default;
    virtual void execute(PassContext& context) = 0;
};

template <class Data, class Execute> class TypedPassBody final : public PassBody {
public:
    explicit TypedPassBody(Execute execute) : execute_(std::move(execute)) {}
    void execute(PassContext& context) override { execute_(std::as_const(data), context); }

    Data data{};

private:
    Execute execute_;
};

} // namespace detail

} // namespace hachure::gpu
