#pragma once

#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/systems/shade_strokes/shade_chains.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace hachure {

/// What was written to buffers of the GPU.
struct ShadeUploads {
    std::uint64_t calls = 0;
    std::uint64_t bytes = 0;

    friend bool operator==(const ShadeUploads&, const ShadeUploads&) = default;
};

/// The strokes of one surface on the GPU: copies of its chains' arrays, of which only what changed is written, and room
/// for what each view makes of them. Buffers grow, by half more than is needed, and never shrink.
class ShadeBuffers {
public:
    /// Copies what changed since the last call, or all of it for other chains than then; their changes are forgotten.
    /// `shares`: how much of their amplitude strokes keep, per vertex of the mesh, or none; with another version
    /// whenever they are others.
    void update(ShadeChains& chains, std::span<const float> shares = {}, std::uint64_t shares_version = 0);

    [[nodiscard]] std::uint32_t node_count() const { return node_count_; }
    [[nodiscard]] std::uint32_t segment_count() const { return segment_count_; }

    /// Since the buffers were made.
    [[nodiscard]] const ShadeUploads& uploads() const { return uploads_; }

    gpu::Buffer nodes;     ///< ShadeNode per slot
    gpu::Buffer segments;  ///< ShadeSegment per slot
    gpu::Buffer delivered; ///< float per cell: shade
    gpu::Buffer shares;    ///< float per vertex of the mesh; none where strokes keep all of their amplitude

    // Written by the GPU, as shaders/shade_strokes has them.
    gpu::Buffer ribs;              ///< per node: places of its rib points in the world
    gpu::Buffer seen;              ///< per segment: Seen of data.glsl
    gpu::Buffer counts;            ///< per group of segments and batch
    gpu::Buffer list;              ///< slots of the segments that are seen, batch after batch
    gpu::VertexArray vertex_array; ///< one slot of the list per instance, at location 0

private:
    void grow_nodes(std::size_t count);
    void grow_segments(std::size_t count);
    template <class T> bool patch(gpu::Buffer& buffer, const SlotArray<T>& values, bool all);
    void copy_shares(std::span<const float> values);
    void patch_delivered(const ShadeChains& chains);

    const ShadeChains* chains_ = nullptr;
    std::uint32_t node_count_ = 0, segment_count_ = 0;
    std::uint64_t shares_version_ = 0;
    std::vector<float> last_delivered_, new_delivered_;
    ShadeUploads uploads_;
};

} // namespace hachure
