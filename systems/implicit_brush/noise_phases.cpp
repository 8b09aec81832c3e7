#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/noise_phases.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

constexpr std::size_t most_samples = 512;
constexpr std::size_t enough_samples = 8;

/// A view that moves on by more of the picture's height in a frame is another one: a cut.
constexpr float cut = 0.25f;

std::span<const glm::vec3> positions_of(const SurfaceMesh& mesh, const DrawItem& item) {
    return item.shape.positions.empty() ? std::span<const glm::vec3>(mesh.positions) : item.shape.positions;
}

/// (x, y, depth) on the screen of a point of the entity.
glm::vec3 on_screen(const glm::mat4& clip_from_entity, const glm::vec3& point, glm::vec2 viewport) {
    const glm::vec4 clip = clip_from_entity * glm::vec4(point, 1.0f);
    return {(0.5f + 0.5f * glm::vec2(clip) / clip.w) * viewport, clip.w};
}

/// The same of some vertices.
std::vector<glm::vec3> sampled(std::span<const glm::vec3> positions, const glm::mat4& clip_from_entity,
                               glm::vec2 viewport) {
    const std::size_t stride = (positions.size() + most_samples - 1) / most_samples;
    std::vector<glm::vec3> result;
    for (std::size_t i = 0; i < positions.size(); i += stride)
        result.push_back(on_screen(clip_from_entity, positions[i], viewport));
    return result;
}

/// How the view before and this one differ where no vertices are in view, large triangles close by: by a grid of places
/// on the screen, as far off as the middle of the mesh, or where the eye is nearer than that or beyond it, near.
PointMotion motion_of_view(const SurfaceMesh& mesh, const glm::mat4& before, const glm::mat4& now, glm::vec2 viewport) {
    const glm::mat4 entity_from_clip = glm::inverse(before);
    const glm::vec4 middle = before * glm::vec4(mesh.bounds.center(), 1.0f);
    const float depth = middle.w > 0.0f ? std::clamp(middle.z / middle.w, 0.0f, 1.0f) : 0.5f;
    std::vector<glm::vec3> from, to;
    for (const float y : {-1.0f, 0.0f, 1.0f})
        for (const float x : {-1.0f, 0.0f, 1.0f}) {
            const glm::vec4 point = entity_from_clip * glm::vec4(x, y, std::max(depth, 1e-6f), 1.0f);
            from.push_back(on_screen(before, glm::vec3(point) / point.w, viewport));
            to.push_back(on_screen(now, glm::vec3(point) / point.w, viewport));
        }
    return point_motion(from, to, viewport);
}

/// Where a phase stands at that time: whole part its period, the rest its place in it.
double phase_time(double clock, std::size_t phase) { return clock + 0.5 * static_cast<double>(phase); }

/// It counts most in the middle of its period and not at all when noise is made; sin^2 + cos^2 = 1 for both.
float phase_weight(double clock, std::size_t phase) {
    const double time = phase_time(clock, phase);
    return static_cast<float>(std::sin(glm::pi<double>() * (time - std::floor(time))));
}

/// Noise of one period is another one than that of the next because it is taken from another place.
glm::vec2 random_shift(Entity entity, std::size_t phase, std::uint64_t version) {
    const std::uint64_t bits = gpu::key_of(entity.index, static_cast<std::uint64_t>(phase), version);
    return {static_cast<float>(bits & 0xfffu), static_cast<float>((bits >> 32) & 0xfffu)};
}

} // namespace

PointMotion point_motion(std::span<const glm::vec3> before, std::span<const glm::vec3> now, glm::vec2 viewport) {
    glm::vec2 sum(0.0f);
    float squares = 0.0f;
    PointMotion motion;
    for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i) {
        const glm::vec2 off = glm::abs(glm::vec2(before[i]) / viewport - 0.5f);
        if (!(before[i].z > 0.0f) || !(now[i].z > 0.0f) || std::max(off.x, off.y) > 0.6f) continue;
        const glm::vec2 step = glm::vec2(now[i]) - glm::vec2(before[i]);
        sum += step;
        squares += glm::dot(step, step);
        ++motion.points;
    }
    if (motion.points == 0) return motion;
    const auto count = static_cast<float>(motion.points);
    motion.mean = sum / count;
    motion.apart = std::sqrt(std::max(0.0f, squares / count - glm::dot(motion.mean, motion.mean)));
    return motion;
}

void NoisePhases::update(const MeshStore& store, const DrawList& list, const View& view) {
    ++frame_;
    gpu::KeyHash key;
    key.add(list.key);
    for (const DrawItem& item : list.items) {
        Track& track = tracks_[item.entity];
        follow(store, item, view, track);
        key.add(track.clock);
        for (const Pose& pose : track.poses) key.add(pose.version);
    }
    std::erase_if(tracks_, [this](const auto& entry) { return entry.second.frame != frame_; });
    key_ = key.value();
}

void NoisePhases::follow(const MeshStore& store, const DrawItem& item, const View& view, Track& track) {
    const glm::mat4 clip_from_entity = view.clip_from_world * item.world_from_entity;
    const bool known = track.frame > 0 && track.mesh == item.mesh;
    const bool moved = !known || track.clip_from_entity != clip_from_entity || track.shape != item.shape.version;
    track.frame = frame_;
    if (!moved) return;
    const glm::vec2 viewport(view.width, view.height);
    const SurfaceMesh& mesh = store.mesh(item.mesh);
    std::vector<glm::vec3> samples = sampled(positions_of(mesh, item), clip_from_entity, viewport);
    PointMotion motion;
    if (known) motion = point_motion(track.samples, samples, viewport);
    if (known && motion.points < enough_samples)
        motion = motion_of_view(mesh, track.clip_from_entity, clip_from_entity, viewport);
    const bool again = !known || !(glm::length(motion.mean) < cut * viewport.y);
    const double before = track.clock;
    if (std::isfinite(motion.apart)) track.clock += static_cast<double>(motion.apart / lifetime_);
    track.mesh = item.mesh;
    track.clip_from_entity = clip_from_entity;
    track.shape = item.shape.version;
    track.samples = std::move(samples);
    for (std::size_t phase = 0; phase < 2; ++phase) {
        const bool over = std::floor(phase_time(track.clock, phase)) != std::floor(phase_time(before, phase));
        if (again || over) start(item, view, track.poses[phase]);
    }
}

void NoisePhases::start(const DrawItem& item, const View& view, Pose& pose) {
    pose.clip_from_entity = view.clip_from_world * item.world_from_entity;
    pose.viewport = {view.width, view.height};
    pose.pixel_size = view.pixel_size;
    pose.positions.assign(item.shape.positions.begin(), item.shape.positions.end());
    ++pose.version;
}

void NoisePhases::draw_item(const World& world, RenderContext& render, const DrawItem& item, const Track& track) {
    const MeshStore& store = world.resource<MeshStore>();
    const SurfaceMesh& mesh = store.mesh(item.mesh);
    if (mesh.indices.empty()) return;
    // What the GPU deforms has no vertices here: it is taken for stiff.
    const bool deforms = !item.shape.on_gpu && (item.shape.version != 0 || !track.poses[0].positions.empty() ||
                                                !track.poses[1].positions.empty());
    gpu::ProgramSource source{.vertex = "implicit_brush/past.vert", .fragment = "implicit_brush/past.frag"};
    if (deforms) source.defines.push_back({"DEFORMED", ""});
    gpu::Program& program = render.shaders->program(source);
    program.set("world_from_entity", item.world_from_entity);
    std::array<glm::mat4, 2> clips;
    std::array<glm::vec4, 2> shapes, phases;
    for (std::size_t k = 0; k < 2; ++k) {
        const Pose& pose = track.poses[k];
        clips[k] = pose.clip_from_entity;
        shapes[k] = {pose.viewport, pose.pixel_size, 0.0f};
        phases[k] = {random_shift(item.entity, k, pose.version), phase_weight(track.clock, k), 0.0f};
        if (!deforms) continue;
        const std::span<const glm::vec3> own(mesh.positions);
        positions_[k]
            .get(item.entity, gpu::key_of(pose.version, item.mesh), pose.positions.empty() ? own : pose.positions)
            .bind(static_cast<GLuint>(1 + k));
    }
    program.set("past_clip_from_entity", std::span<const glm::mat4>(clips));
    program.set("past_view", std::span<const glm::vec4>(shapes));
    program.set("phase", std::span<const glm::vec4>(phases));
    program.use();
    render.meshes.vertex_array(store, item).bind();
    gpu::gl().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
}

void NoisePhases::draw(const World& world, RenderContext& render, const PhaseTextures& textures,
                       const gpu::Rect& rect) {
    const std::vector<DrawItem>& items = world.resource<DrawList>().items;
    std::vector<Entity> deformed;
    for (const DrawItem& item : items)
        if (item.shape.version != 0) deformed.push_back(item.entity);
    for (VertexTextures& positions : positions_) positions.forget_all_but(deformed);
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({textures.pasts[0], textures.pasts[1]});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = rect});
    render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
    render.backend->texture(textures.depth_buffer).bind(0);
    for (const DrawItem& item : items) draw_item(world, render, item, tracks_.at(item.entity));
}

} // namespace hachure
