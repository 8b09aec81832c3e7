#pragma once

#include <hachure/runtime/gpu/frame_graph_declaration.h>
#include <hachure/runtime/gpu/frame_graph_pool.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace hachure::gpu::detail {

/// What stays from frame to frame: which texture holds which results, and which side effects have been done. Textures
/// and passes are known by their names. Textures that the graph owns came from its pool and go back to it.
class KeptResults {
public:
    explicit KeptResults(TexturePool& pool) : pool_(&pool) {}

    /// Whether the texture kept for `node` holds just what this frame would write into it.
    [[nodiscard]] bool holds(const TextureNode& node) const;

    /// The id of the texture kept for `node`, whose contents are unfinished from now on if this frame's passes write
    /// it. Empty when none is kept; one of another shape or owner is dropped.
    std::optional<std::uint32_t> reuse(const TextureNode& node);

    /// Keeps texture `id` for `node`; its contents are unfinished.
    void keep(const TextureNode& node, std::uint32_t id);

    /// The contents of the texture kept for `node` are now those of its last version.
    void finish(const TextureNode& node);

    /// Keeps nothing for `node` any more.
    void drop(const TextureNode& node);

    /// Whether the pass did its side effect last time under the same signature.
    [[nodiscard]] bool effect_done(const PassNode& pass) const;

    /// This frame has a pass with a side effect, which counts as undone from now on if it runs.
    void reuse_effect(const PassNode& pass);

    /// The pass has done its side effect.
    void finish_effect(const PassNode& pass);

    /// Ends a frame: gives back what no frame has used for `idle_frames` frames.
    void end_frame(std::uint32_t idle_frames);

    /// No contents and no side effect stand any more.
    void forget();

    /// Bytes of the textures kept that the graph owns.
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Texture {
        std::uint32_t id = 0;
        TextureDesc desc;
        bool owned = true;
        std::optional<std::uint64_t> signature; // of the contents; empty: unfinished
        std::uint32_t idle = 0;                 // whole frames without use
    };

    struct Effect {
        std::optional<std::uint64_t> signature; // empty: not done
        std::uint32_t idle = 0;
    };

    [[nodiscard]] static bool fits(const Texture& texture, const TextureNode& node);
    void give_back(const Texture& texture);

    TexturePool* pool_;
    std::unordered_map<std::uint64_t, Texture> textures_; // by the key of the name
    std::unordered_map<std::uint64_t, Effect> effects_;
};

} // namespace hachure::gpu::detail
