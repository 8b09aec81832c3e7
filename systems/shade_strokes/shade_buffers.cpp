#include <hachure/systems/shade_strokes/shade_buffers.h>
#include <hachure/systems/shade_strokes/stroke_layout.h>

#include <algorithm>
#include <string>

namespace hachure {
namespace {

constexpr std::size_t delivered_block = 64; // cells that are compared, and written, together

std::size_t with_room(std::size_t count) { return std::max<std::size_t>(64, count + count / 2); }

gpu::Buffer gpu_buffer(std::size_t bytes, const char* label) {
    return gpu::Buffer(bytes, gpu::BufferUsage::immutable, label);
}

} // namespace

void ShadeBuffers::update(ShadeChains& chains, std::span<const float> shares_now, std::uint64_t shares_version) {
    const bool other = chains_ != &chains, narrowed = other || shares_version != shares_version_;
    if (!narrowed && !chains.nodes.changed() && !chains.segments.changed()) return;
    if (narrowed) copy_shares(shares_now);
    shares_version_ = shares_version;
    chains_ = &chains;
    node_count_ = static_cast<std::uint32_t>(chains.nodes.all().size());
    segment_count_ = static_cast<std::uint32_t>(chains.segments.all().size());
    if (patch(nodes, chains.nodes, other)) grow_nodes(node_count_);
    if (patch(segments, chains.segments, other)) grow_segments(segment_count_);
    patch_delivered(chains);
    chains.nodes.forget_changes();
    chains.segments.forget_changes();
}

/// Returns whether there is another buffer now.
template <class T> bool ShadeBuffers::patch(gpu::Buffer& buffer, const SlotArray<T>& values, bool all) {
    const std::span<const T> slots = values.all();
    const auto write = [&](std::size_t first, std::size_t count) {
        buffer.update(slots.subspan(first, count), first * sizeof(T));
        ++uploads_.calls;
        uploads_.bytes += count * sizeof(T);
    };
    const bool grown = !buffer || buffer.bytes() < slots.size_bytes();
    if (grown) buffer = gpu::Buffer(with_room(slots.size()) * sizeof(T), gpu::BufferUsage::dynamic, "shade chains");
    if ((grown || all) && !slots.empty())
        write(0, slots.size());
    else
        values.each_change(write);
    return grown;
}

void ShadeBuffers::grow_nodes(std::size_t count) {
    ribs = gpu_buffer(with_room(count) * rib_points * stroke_layout::vector_bytes, "shade ribs");
}

void ShadeBuffers::grow_segments(std::size_t count) {
    const std::size_t room = with_room(count), groups = (room + stroke_layout::group - 1) / stroke_layout::group;
    seen = gpu_buffer(room * stroke_layout::seen_bytes, "shade segments seen");
    counts = gpu_buffer(groups * stroke_layout::batches * sizeof(std::uint32_t), "shade batch counts");
    list = gpu_buffer(room * sizeof(std::uint32_t), "shade segment list");
    vertex_array = gpu::VertexArray("shade strokes");
    vertex_array.set_attribute({.components = 1, .type = GL_UNSIGNED_INT, .kind = gpu::AttributeKind::integer});
    vertex_array.set_vertex_buffer(0, list, sizeof(std::uint32_t), 0, 1);
}

void ShadeBuffers::copy_shares(std::span<const float> values) {
    if (values.empty()) {
        shares = gpu::Buffer();
        return;
    }
    if (!shares || shares.bytes() != values.size_bytes())
        shares = gpu::Buffer(values.size_bytes(), gpu::BufferUsage::dynamic, "shade narrowing");
    shares.update(values);
    ++uploads_.calls;
    uploads_.bytes += values.size_bytes();
}

/// Of cells there are few, and no record of which changed.
void ShadeBuffers::patch_delivered(const ShadeChains& chains) {
    new_delivered_.clear();
    for (const ShadeCellState& cell : chains.cells) new_delivered_.push_back(cell.delivered);
    const bool all = last_delivered_.size() != new_delivered_.size();
    const std::span<const float> values(new_delivered_);
    if (!delivered || delivered.bytes() < values.size_bytes())
        delivered = gpu::Buffer(std::max<std::size_t>(values.size_bytes(), 4), gpu::BufferUsage::dynamic, "shade");
    for (std::size_t first = 0; first < values.size(); first += delivered_block) {
        const std::span<const float> block = values.subspan(first, std::min(delivered_block, values.size() - first));
        if (!all && std::ranges::equal(block, std::span(last_delivered_).subspan(first, block.size()))) continue;
        delivered.update(block, first * sizeof(float));
        ++uploads_.calls;
        uploads_.bytes += block.size_bytes();
    }
    last_delivered_.swap(new_delivered_);
}

} // namespace hachure
