#include <hachure/components/curvature.h>
#include <hachure/components/deformed.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/implicit_brush.h>
#include <hachure/components/metal.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/shade_strokes.h>
#include <hachure/components/skin.h>
#include <hachure/components/surface.h>
#include <hachure/components/toon.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/parallel.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/deform/deform_input.h>
#include <hachure/systems/deform/deform_pass.h>
#include <hachure/systems/deform/shape_bounds.h>
#include <hachure/systems/deform/shape_update.h>

#include <glm/matrix.hpp>

#include <deque>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using Places = Query<const WorldTransform>;
using Bodies = Query<const Surface, const WorldTransform, AnyOf<const Skin, const MorphWeights>, Optional<const Deform>,
                     Optional<const EdgeLines>, Optional<const Curvature>, Optional<const Metal>, Optional<const Toon>,
                     Optional<const ShadeStrokes>>;

/// Places of joints in the world, and what they make of a skin's rest pose.
class Palettes {
public:
    Palettes(const Places& places, const MeshStore& store) : places_(places), store_(store) {}

    /// Of a surface that stands at `surface`; into `palette`.
    void make(const Skin& skin, const glm::mat4& surface, std::vector<geometry::JointMatrix>& palette) {
        const SkinBinding& binding = store_.skin(skin.binding);
        const glm::dmat4 world_from_surface(surface);
        joints_.resize(skin.joints.size());
        for (std::size_t j = 0; j < joints_.size(); ++j) {
            const auto place = places_.find(skin.joints[j]);
            joints_[j] = place ? glm::dmat4(std::get<const WorldTransform&>(*place).matrix)
                               : world_from_surface * glm::dmat4(binding.rest[j]);
        }
        palette.resize(joints_.size() + 1);
        geometry::SkinPaletteJob job{
            .joints_double = joints_, .inverse_bind = binding.inverse_bind, .palette = palette};
        // A surface that is flattened has no inverse; nothing of it is seen, whatever its shape.
        if (glm::determinant(world_from_surface) != 0.0) job.to_out = glm::inverse(world_from_surface);
        job.run();
    }

private:
    const Places& places_;
    const MeshStore& store_;
    std::vector<glm::dmat4> joints_;
};

/// The shape of a surface that had none.
struct Newcomer {
    Entity entity;
    Deformed shape;
};

class DeformSystem {
public:
    /// `gpu`: there is one, so that surfaces that ask for it can be left to it.
    explicit DeformSystem(bool gpu) : gpu_(gpu) {}

    void operator()(Bodies bodies, Places places, Query<Deformed> shapes, Removed<Skin> unskinned,
                    Removed<MorphWeights> unmorphed, Removed<EdgeLines> unlined, Removed<Curvature> unbent,
                    Removed<Metal> unmilled, Removed<Toon> untoned, Removed<ShadeStrokes> unshaded,
                    Query<const ImplicitBrush> brushes, LastRun last, const MeshStore& store,
                    const FrameRequests& requests, DeformInputs& inputs, DeformCounts& counts, Commands& commands) {
        counts = {};
        forget(bodies, unskinned, inputs);
        forget(bodies, unmorphed, inputs);
        // Both compare positions of two frames.
        const bool wanted = gpu_ && !requests.wants("velocity") && !carry_noise(brushes);
        const bool elsewhere = wanted != leave_to_gpu_ || !unlined.empty() || !unbent.empty() || !unmilled.empty() ||
                               !untoned.empty() || !unshaded.empty();
        leave_to_gpu_ = wanted;
        if (!elsewhere && !anything_moved(bodies, places, last)) return;
        collect(bodies, places, shapes, store, inputs, counts);
        run();
        for (ShapeUpdate& update : updates_) counts.vertices += update.vertices();
        counts.surfaces += updates_.size();
        for (Newcomer& newcomer : newcomers_) commands.add(newcomer.entity, std::move(newcomer.shape));
        updates_.clear();
        newcomers_.clear();
    }

private:
    static bool anything_moved(const Bodies& bodies, const Places& places, LastRun last) {
        return !places.changed_since<WorldTransform>(last.tick).empty() ||
               !bodies.changed_since<Surface, Skin, MorphWeights, Deform, EdgeLines, Curvature>(last.tick).empty() ||
               !bodies.changed_since<Metal, Toon, ShadeStrokes>(last.tick).empty();
    }

    /// A brush may paint on surfaces of entities other than its own.
    static bool carry_noise(const Query<const ImplicitBrush>& brushes) {
        bool found = false;
        for (auto [entity, brush] : brushes) found = found || (brush.visible && brush.grain == BrushGrain::advected);
        return found;
    }

    template <class C> void forget(const Bodies& bodies, const Removed<C>& removed, DeformInputs& inputs) {
        for (const Entity entity : removed) {
            if (bodies.contains(entity)) continue;
            states_.erase(entity);
            inputs.of.erase(entity);
        }
    }

    /// Where it is to be deformed: as it asks, unless something looks at its positions, or computes normals from them,
    /// on the CPU. What else comes to do so has its component named here.
    [[nodiscard]] DeformDevice device_of(const SurfaceMesh& mesh, const Deform& settings, const EdgeLines* lines,
                                         const Curvature* curvature, const Metal* metal, const Toon* toon,
                                         const ShadeStrokes* strokes) const {
        const bool carries = toon && toon->abstraction > 0.0f; // abstracted normals, by the palette
        const bool can = leave_to_gpu_ && !lines && !curvature && !metal && !carries && !strokes &&
                         settings.normals == DeformedNormals::blended && !mesh.positions.empty() &&
                         mesh.normals.size() == mesh.positions.size();
        return can ? settings.device : DeformDevice::cpu;
    }

    /// Finds out what is to be deformed.
    void collect(const Bodies& bodies, const Places& places, const Query<Deformed>& shapes, const MeshStore& store,
                 DeformInputs& inputs, DeformCounts& counts) {
        Palettes palettes(places, store);
        for (auto [entity, surface, transform, skin, morph, asked, lines, curvature, metal, toon, strokes] : bodies) {
            const SurfaceMesh& mesh = store.mesh(surface.mesh);
            const bool skinned = skin && skin->joints.size() == mesh.skin.joint_count() && mesh.skin.vertex_count() > 0;
            const bool morphing = morph && morph->values.size() == mesh.morphs.size();
            if (!skinned && !morphing) continue;
            palette_.clear();
            if (skinned) palettes.make(*skin, transform.matrix, palette_);
            Deform settings = asked ? *asked : Deform{};
            settings.device = device_of(mesh, settings, lines, curvature, metal, toon, strokes);
            DeformState& state = states_[entity];
            ShapeUpdate update(mesh, state);
            if (!update.prepare(surface.mesh, settings,
                                morphing ? std::span<const float>(morph->values) : std::span<const float>(), palette_))
                continue;
            Deformed& shape = shape_of(entity, shapes);
            shape.on_gpu = settings.device == DeformDevice::gpu;
            if (shape.on_gpu) {
                inputs.of[entity] = leave_to_gpu(mesh, state, shape, counts);
                continue;
            }
            inputs.of.erase(entity);
            update.resize(shape);
            updates_.push_back(std::move(update));
        }
    }

    Deformed& shape_of(Entity entity, const Query<Deformed>& shapes) {
        if (const auto found = shapes.find(entity)) return std::get<Deformed&>(*found);
        return newcomers_.emplace_back(Newcomer{entity, {}}).shape;
    }

    /// Makes `shape` one that the GPU fills in, and says from what.
    DeformInput leave_to_gpu(const SurfaceMesh& mesh, const DeformState& state, Deformed& shape, DeformCounts& counts) {
        counts.vertices += mesh.positions.size();
        ++counts.surfaces;
        ++counts.on_gpu;
        auto bounds = bounds_.find(state.mesh);
        if (bounds == bounds_.end()) bounds = bounds_.emplace(state.mesh, shape_bounds(mesh)).first;
        shape.positions = {};
        shape.normals = {};
        shape.tangents = {};
        shape.bounds = bounds_of_shape(bounds->second, state.weights, state.palette, state.settings.method);
        shape.version = ++version_;
        return deform_input(state, shape.version);
    }

    void run() {
        tasks_.clear();
        for (std::size_t i = 0; i < updates_.size(); ++i)
            for (std::size_t range = 0; range < updates_[i].ranges(); ++range) tasks_.emplace_back(i, range);
        parallel_for(tasks_.size(),
                     [this](std::size_t task) { updates_[tasks_[task].first].run(tasks_[task].second); });
        const std::uint64_t first = version_ + 1;
        version_ += updates_.size();
        parallel_for(updates_.size(), [this, first](std::size_t i) { updates_[i].finish(first + i); });
    }

    std::unordered_map<Entity, DeformState> states_;
    std::vector<geometry::JointMatrix> palette_;
    std::vector<ShapeUpdate> updates_;
    std::vector<std::pair<std::size_t, std::size_t>> tasks_; ///< update and range
    std::deque<Newcomer> newcomers_;                         ///< updates point into it
    std::unordered_map<std::uint32_t, ShapeBounds> bounds_;  ///< by mesh, of those that are deformed on the GPU
    std::uint64_t version_ = 0;
    bool gpu_;
    bool leave_to_gpu_ = false; ///< in this frame
};

} // namespace

void register_deform(App& app) {
    app.add_component<Deform>();
    World& world = app.world();
    if (!world.find_resource<MeshStore>()) world.set_resource(MeshStore{});
    world.set_resource(DeformCounts{});
    static_cast<void>(frame_requests(world));
    app.add_system(Stage::deform, "deform", DeformSystem(world.find_resource<RenderContext>() != nullptr));
    register_deform_pass(app);
}

} // namespace hachure
