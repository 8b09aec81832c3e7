#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/geometry/skin_arguments.h>
#include <hachure/runtime/geometry/vertex_range.h>

namespace hachure::geometry {
namespace {

template <class T> auto* floats(std::span<T> values) {
    using Float = std::conditional_t<std::is_const_v<T>, const float, float>;
    return values.empty() ? nullptr : reinterpret_cast<Float*>(values.data());
}

const float* block_weights(const SkinBlocks& blocks) {
    return blocks.all_weights().empty() ? nullptr : blocks.all_weights().front().of_vertex.data();
}

skin_loop::Loop loop_of(const SkinJob& job) {
    const skin_loop::Variant variant{job.method == SkinMethod::dual_quaternion, job.weights->joint_bytes(),
                                     job.weights->influences() == 8};
    if (job.instructions == InstructionSet::avx512) return skin_loop::avx512_loop(variant);
    if (job.instructions == InstructionSet::avx2) return skin_loop::avx2_loop(variant);
    return skin_loop::portable_loop(variant);
}

} // namespace

void SkinJob::validate() const {
    const std::size_t count = rest_positions.size();
    HACHURE_ASSERT(weights != nullptr && weights->vertex_count() == count, "weights of every vertex");
    HACHURE_ASSERT(positions.size() == count, "one position per vertex");
    HACHURE_ASSERT(normals.size() == rest_normals.size() && (normals.empty() || normals.size() == count),
                   "one normal per vertex or none");
    HACHURE_ASSERT(tangents.size() == rest_tangents.size() && (tangents.empty() || tangents.size() == normals.size()),
                   "one tangent per vertex or none, and none without normals");
    const std::size_t entries = method == SkinMethod::linear ? palette.size() : motions.size();
    HACHURE_ASSERT(entries == weights->palette_size(), "a palette entry per joint and one more");
    HACHURE_ASSERT(is_supported(instructions), "instructions that this machine has");
}

void SkinJob::run() {
    const std::size_t end = end_of(range, rest_positions.size());
    bounds = {};
    if (range.first >= end) return;
    skin_loop::Arguments arguments{floats(rest_positions),
                                   floats(rest_normals),
                                   floats(rest_tangents),
                                   weights->packed_joints().data(),
                                   weights->weights().data(),
                                   weights->blocks().all_firsts().data(),
                                   weights->blocks().all_joints().data(),
                                   block_weights(weights->blocks()),
                                   method == SkinMethod::linear ? &palette[0].row[0].x : &motions[0].real.x,
                                   floats(positions),
                                   floats(normals),
                                   floats(tangents),
                                   range.first,
                                   end,
                                   {bounds.low.x, bounds.low.y, bounds.low.z},
                                   {bounds.high.x, bounds.high.y, bounds.high.z}};
    loop_of (*this)(arguments);
    bounds.low = {arguments.low[0], arguments.low[1], arguments.low[2]};
    bounds.high = {arguments.high[0], arguments.high[1], arguments.high[2]};
}

void skin_in_parallel(SkinJob& job) { run_ranges_in_parallel(job, job.rest_positions.size()); }

} // namespace hachure::geometry
