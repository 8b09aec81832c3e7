#include <hachure/systems/deform/gpu_deformer.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <string>

namespace hachure {
namespace {

constexpr std::uint32_t group_size = 64; // as the shader has it
constexpr std::uint32_t most_groups = 65535;

std::size_t joint_words(const geometry::SkinWeights& skin) {
    return skin.packed_joints().size() / sizeof(std::uint32_t); // 4 or 8 influences: whole words
}

std::vector<std::uint32_t> influence_words(const geometry::SkinWeights& skin) {
    const std::span<const std::byte> joints = skin.packed_joints();
    const std::span<const float> weights = skin.weights();
    std::vector<std::uint32_t> words(joint_words(skin) + weights.size());
    std::memcpy(words.data(), joints.data(), joints.size());
    std::memcpy(words.data() + joint_words(skin), weights.data(), weights.size_bytes());
    return words;
}

/// Appends one table of shaders/deform/morph.glsl: its places go to `places`, its displacements behind `words`.
void append_moves(const geometry::MorphTargets& targets,
                  geometry::MorphTargets::Array geometry::MorphTargets::Target::*which, std::size_t places,
                  std::vector<std::uint32_t>& words) {
    const std::size_t count = targets.vertex_count();
    std::vector<std::uint32_t> next(count + 1, 0); // first how many each vertex has, then where its next one goes
    const auto for_each = [&](const auto& visit) {
        for (std::size_t t = 0; t < targets.size(); ++t) {
            const geometry::MorphTargets::Array& array = targets[t].*which;
            for (std::size_t i = 0; i < array.deltas.size(); ++i)
                if (array.deltas[i] != glm::vec3(0.0f))
                    visit(t, array.vertices.empty() ? i : array.vertices[i], array.deltas[i]);
        }
    };
    for_each([&](std::size_t, std::size_t v, const glm::vec3&) { next[v] += 4; });
    auto place = static_cast<std::uint32_t>(words.size());
    for (std::size_t v = 0; v <= count; ++v) {
        const std::uint32_t size = next[v];
        next[v] = words[places + v] = place;
        place += size;
    }
    words.resize(place);
    for_each([&](std::size_t t, std::size_t v, const glm::vec3& delta) {
        words[next[v]++] = static_cast<std::uint32_t>(t);
        for (int i = 0; i < 3; ++i) words[next[v]++] = std::bit_cast<std::uint32_t>(delta[i]);
    });
}

std::vector<std::uint32_t> morph_words(const geometry::MorphTargets& targets) {
    using Target = geometry::MorphTargets::Target;
    const std::size_t places = targets.vertex_count() + 1;
    std::vector<std::uint32_t> words(3 * places);
    append_moves(targets, &Target::positions, 0, words);
    append_moves(targets, &Target::normals, places, words);
    append_moves(targets, &Target::tangents, 2 * places, words);
    return words;
}

gpu::ProgramSource program_source(const SurfaceMesh& mesh, const DeformInput& input) {
    gpu::ProgramSource source{.compute = "deform/deform.comp"};
    if (!mesh.tangents.empty()) source.defines.push_back({"TANGENTS"});
    if (input.morphs) source.defines.push_back({"MORPH"});
    if (input.palette_size == 0) return source;
    source.defines.push_back({"SKIN"});
    source.defines.push_back({"INFLUENCES", std::to_string(mesh.skin.influences())});
    source.defines.push_back({"JOINT_BITS", std::to_string(8 * mesh.skin.joint_bytes())});
    if (input.method == geometry::SkinMethod::dual_quaternion) source.defines.push_back({"DUAL_QUATERNION"});
    return source;
}

void dispatch(std::size_t vertices) {
    const auto groups = static_cast<std::uint32_t>((vertices + group_size - 1) / group_size);
    const std::uint32_t columns = std::min(groups, most_groups);
    gpu::gl().DispatchCompute(columns, (groups + columns - 1) / columns, 1);
}

} // namespace

bool GpuDeformer::plan(const DrawList& list, const DeformInputs& inputs, const RenderContext& render) {
    const bool edited = generation_ != render.shaders->generation();
    bool any = false;
    planned_.clear();
    for (const DrawItem& item : list.items) {
        if (!item.shape.on_gpu) continue;
        any = true;
        const auto input = inputs.of.find(item.entity);
        // A copy that was made in this very frame has no input of its own yet.
        if (input == inputs.of.end() || input->second.version != item.shape.version) continue;
        if (edited || !render.meshes.has_shape(item)) planned_.push_back(item);
    }
    generation_ = render.shaders->generation();
    runs_ += !planned_.empty();
    return any;
}

std::uint64_t GpuDeformer::vertices(const MeshStore& store) const {
    std::uint64_t count = 0;
    for (const DrawItem& item : planned_) count += store.mesh(item.mesh).positions.size();
    return count;
}

void GpuDeformer::run(const MeshStore& store, const DeformInputs& inputs, RenderContext& render) {
    if (planned_.empty()) return;
    upload_poses(inputs);
    // What drew from the buffers in the last frame is done with them.
    gpu::gl().MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
    for (std::size_t i = 0; i < planned_.size(); ++i)
        deform(store, planned_[i], inputs.of.at(planned_[i].entity), first_poses_[i], render);
    // No dispatch reads what another has written, so one barrier before they are drawn is enough; the second bit is for
    // those who read the buffers back.
    gpu::gl().MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    for (const DrawItem& item : planned_) render.meshes.shape_written(item);
    planned_.clear();
}

const GpuDeformer::MeshData& GpuDeformer::mesh_data(const MeshStore& store, std::uint32_t index) {
    const auto found = meshes_.find(index);
    if (found != meshes_.end()) return found->second;
    const SurfaceMesh& mesh = store.mesh(index);
    MeshData& data = meshes_[index];
    if (mesh.skin.vertex_count() > 0)
        data.influences =
            gpu::Buffer(std::span<const std::uint32_t>(influence_words(mesh.skin)), mesh.name + " influences");
    if (mesh.morphs.size() > 0)
        data.morphs = gpu::Buffer(std::span<const std::uint32_t>(morph_words(mesh.morphs)), mesh.name + " morphs");
    return data;
}

/// All at once: an update per surface would wait for the one before, or copy.
void GpuDeformer::upload_poses(const DeformInputs& inputs) {
    poses_.clear();
    first_poses_.clear();
    for (const DrawItem& item : planned_) {
        const std::vector<glm::vec4>& pose = inputs.of.at(item.entity).pose;
        first_poses_.push_back(poses_.size());
        poses_.insert(poses_.end(), pose.begin(), pose.end());
    }
    if (poses_.empty()) poses_.emplace_back(0.0f); // all of them at rest: a buffer all the same
    const std::size_t bytes = poses_.size() * sizeof(glm::vec4);
    if (pose_buffer_.bytes() < bytes) pose_buffer_ = gpu::Buffer(bytes + bytes / 2, gpu::BufferUsage::dynamic, "poses");
    pose_buffer_.update(std::span<const glm::vec4>(poses_));
}

void GpuDeformer::deform(const MeshStore& store, const DrawItem& item, const DeformInput& input, std::size_t pose,
                         RenderContext& render) {
    using gpu::BufferBinding::storage;
    const SurfaceMesh& mesh = store.mesh(item.mesh);
    const GpuMesh& rest = render.meshes.mesh(store, item.mesh);
    const MeshData& data = mesh_data(store, item.mesh);
    rest.positions.bind_base(storage, 0);
    rest.normals.bind_base(storage, 1);
    if (rest.tangents) rest.tangents.bind_base(storage, 2);
    pose_buffer_.bind_base(storage, 3);
    if (input.palette_size > 0) data.influences.bind_base(storage, 4);
    if (input.morphs) data.morphs.bind_base(storage, 5);
    render.meshes.shape_buffer(store, item).bind_base(storage, 6);
    gpu::Program& program = render.shaders->program(program_source(mesh, input));
    program.set("vertex_count", static_cast<std::uint32_t>(mesh.positions.size()));
    program.set("first_entry", static_cast<std::uint32_t>(pose));
    program.set("first_weight", static_cast<std::uint32_t>(pose + 4 * input.palette_size));
    program.set("weight_words", static_cast<std::uint32_t>(joint_words(mesh.skin)));
    program.use();
    dispatch(mesh.positions.size());
}

} // namespace hachure
