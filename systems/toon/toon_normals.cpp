#include <hachure/runtime/parallel.h>
#include <hachure/systems/toon/toon_normals.h>

#include <utility>

namespace hachure {

namespace {

/// Whether the mesh is skinned, and the shape is one of this mesh and method: it stays for a while when they change.
bool can_carry(const SurfaceMesh& mesh, geometry::SkinMethod method, const Deformed& shape) {
    const std::size_t entries = method == geometry::SkinMethod::linear ? shape.palette.size() : shape.motions.size();
    return entries > 0 && entries == mesh.skin.palette_size() && mesh.skin.vertex_count() == mesh.positions.size();
}

} // namespace

void ToonNormals::update(const ToonSurfaces& surfaces, const Query<AbstractedNormals>& results,
                         const Removed<Toon>& unwanted, const LastRun& last, const MeshStore& store,
                         Commands& commands) {
    for (const Entity entity : unwanted) {
        carried_.erase(entity);
        if (results.contains(entity) && !surfaces.contains(entity)) commands.remove<AbstractedNormals>(entity);
    }
    collect(surfaces, results, last, store, commands);
    compute_rest();
    parallel_for(tasks_.size(), [this](std::size_t i) { finish(tasks_[i]); });
    for (Task& task : tasks_) {
        if (task.shape) task.result.version = ++version_;
        if (const auto found = results.find(task.entity))
            std::get<AbstractedNormals&>(*found) = std::move(task.result);
        else
            commands.add(task.entity, std::move(task.result));
    }
    tasks_.clear();
}

void ToonNormals::collect(const ToonSurfaces& surfaces, const Query<AbstractedNormals>& results, const LastRun& last,
                          const MeshStore& store, Commands& commands) {
    for (auto [entity, surface, toon, deform, shape] :
         surfaces.changed_since<Surface, Toon, Deform, Deformed>(last.tick)) {
        if (toon.abstraction <= 0.0f) {
            carried_.erase(entity);
            if (results.contains(entity)) commands.remove<AbstractedNormals>(entity);
            continue;
        }
        const SurfaceMesh& mesh = store.mesh(surface.mesh);
        const geometry::SkinMethod method = (deform ? *deform : Deform{}).method;
        const bool carried = shape && can_carry(mesh, method, *shape);
        tasks_.push_back({entity, &mesh, AbstractedShapeKey(surface.mesh, toon), method, carried ? shape : nullptr});
        if (carried) {
            std::shared_ptr<std::vector<glm::vec3>>& memory = carried_[entity];
            if (!memory) memory = std::make_shared<std::vector<glm::vec3>>();
            tasks_.back().result.normals = memory;
        } else {
            carried_.erase(entity);
        }
        rest_.try_emplace(tasks_.back().key);
    }
}

/// Of meshes that are new here, each once.
void ToonNormals::compute_rest() {
    std::map<AbstractedShapeKey, const SurfaceMesh*> missing;
    for (const Task& task : tasks_)
        if (!rest_.at(task.key).normals) missing.emplace(task.key, task.mesh);
    std::vector<std::pair<Rest*, std::pair<AbstractedShapeKey, const SurfaceMesh*>>> work;
    for (const auto& [key, mesh] : missing) {
        work.push_back({&rest_.at(key), {key, mesh}});
        work.back().first->version = ++version_;
    }
    parallel_for(work.size(), [&work](std::size_t i) {
        work[i].first->normals = abstracted_normals(*work[i].second.second, work[i].second.first);
    });
}

void ToonNormals::finish(Task& task) {
    const Rest& rest = rest_.at(task.key);
    if (task.shape)
        carry_abstracted_normals(*task.mesh, *rest.normals, task.method, *task.shape, *carried_.at(task.entity));
    else
        task.result = {rest.normals, rest.version};
}

} // namespace hachure
