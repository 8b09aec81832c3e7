#pragma once

#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hachure {

/// A ShadeMesh, and what only statistics need of it.
struct SharedShadeMesh {
    ShadeMesh mesh;
    std::vector<std::uint32_t> triangles; ///< per cell: how many triangles lie in it at least in part
};

/// The ShadeMesh of every mesh that shade is drawn on. Each is made once, on several threads where several are missing,
/// and shared by all meshes of equal contents.
class ShadeMeshes {
public:
    /// Says that a mesh is needed, divided into about so many cells; `make_wanted` makes it.
    void want(const MeshStore& store, std::uint32_t mesh, std::uint32_t cells);

    /// Makes what was wanted and is missing. What is wrong with a mesh is said once per name, and a line says so when
    /// all that took more than a second.
    void make_wanted();

    /// One that was wanted.
    [[nodiscard]] std::shared_ptr<const SharedShadeMesh> get(std::uint32_t mesh, std::uint32_t cells) const;

    /// Drops those that nobody else holds.
    void forget_unused();

    [[nodiscard]] std::size_t size() const { return made_.size(); }

private:
    using Key = std::pair<std::uint64_t, std::uint32_t>; ///< contents of the mesh, cells

    struct Missing {
        Key key;
        const SurfaceMesh* surface;
    };

    void report(const SurfaceMesh& surface, const ShadeMesh& mesh);

    std::unordered_map<std::uint32_t, std::uint64_t> contents_; ///< by mesh of the store
    std::map<Key, std::shared_ptr<const SharedShadeMesh>> made_;
    std::vector<Missing> missing_;
    std::set<std::string, std::less<>> reported_; ///< names of meshes
};

} // namespace hachure
