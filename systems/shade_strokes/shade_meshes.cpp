#include <hachure/runtime/app/log.h>
#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/shade_strokes/shade_meshes.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <span>

namespace hachure {
namespace {

template <class T> void add_bytes_of(gpu::KeyHash& hash, const std::vector<T>& values) {
    hash.add(std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
}

std::uint64_t contents_of(const SurfaceMesh& surface) {
    gpu::KeyHash hash;
    add_bytes_of(hash, surface.positions);
    add_bytes_of(hash, surface.normals);
    add_bytes_of(hash, surface.indices);
    return hash.value();
}

std::vector<std::uint32_t> triangles_per_cell(const ShadeCells& cells) {
    std::vector<std::uint32_t> result(cells.count(), 0), met;
    for (std::size_t t = 0; t + 1 < cells.first_atom.size(); ++t) {
        met.assign(cells.cell_of_atom.begin() + cells.first_atom[t],
                   cells.cell_of_atom.begin() + cells.first_atom[t + 1]);
        std::ranges::sort(met);
        met.erase(std::unique(met.begin(), met.end()), met.end());
        for (const std::uint32_t cell : met) ++result[cell];
    }
    return result;
}

std::shared_ptr<const SharedShadeMesh> make_shared_mesh(const SurfaceMesh& surface, std::uint32_t cells) {
    auto made = std::make_shared<SharedShadeMesh>();
    made->mesh = make_shade_mesh({.positions = surface.positions,
                                  .normals = surface.normals.size() == surface.positions.size()
                                                 ? std::span<const glm::vec3>(surface.normals)
                                                 : std::span<const glm::vec3>(),
                                  .indices = surface.indices,
                                  .cells = cells});
    made->triangles = triangles_per_cell(made->mesh.cells);
    return made;
}

} // namespace

void ShadeMeshes::want(const MeshStore& store, std::uint32_t mesh, std::uint32_t cells) {
    const SurfaceMesh& surface = store.mesh(mesh);
    const auto [contents, is_new] = contents_.try_emplace(mesh, 0);
    if (is_new) contents->second = contents_of(surface);
    const Key key{contents->second, cells};
    if (!made_.contains(key) && std::ranges::find(missing_, key, &Missing::key) == missing_.end())
        missing_.push_back({key, &surface});
}

void ShadeMeshes::make_wanted() {
    if (missing_.empty()) return;
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::shared_ptr<const SharedShadeMesh>> results(missing_.size());
    parallel_for(missing_.size(),
                 [&](std::size_t i) { results[i] = make_shared_mesh(*missing_[i].surface, missing_[i].key.second); });
    for (std::size_t i = 0; i < results.size(); ++i) {
        report(*missing_[i].surface, results[i]->mesh);
        made_.emplace(missing_[i].key, std::move(results[i]));
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (took.count() > 1.0)
        log_note(fmt::format("shade_strokes: looked at {} mesh{} in {:.1f} s, once", missing_.size(),
                             missing_.size() == 1 ? "" : "es", took.count()));
    missing_.clear();
}

void ShadeMeshes::report(const SurfaceMesh& surface, const ShadeMesh& mesh) {
    const std::string text = shade_mesh_report(mesh);
    if (text.empty() || !reported_.insert(surface.name).second) return;
    const std::string name = surface.name.empty() ? "a mesh without a name" : fmt::format("mesh '{}'", surface.name);
    log_note(fmt::format("shade_strokes: strokes of {} end at or leave out {}", name, text));
}

std::shared_ptr<const SharedShadeMesh> ShadeMeshes::get(std::uint32_t mesh, std::uint32_t cells) const {
    return made_.at({contents_.at(mesh), cells});
}

void ShadeMeshes::forget_unused() {
    std::erase_if(made_, [](const auto& entry) { return entry.second.use_count() == 1; });
}

} // namespace hachure
