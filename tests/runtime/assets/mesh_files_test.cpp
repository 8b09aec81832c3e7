#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/geometry/mesh_health.h>
#include <hachure/tests/support/given_models.h>

#include <gmock/gmock.h>

#include <array>
#include <map>
#include <optional>

#include "mesh_file_fixture.h"

namespace hachure::assets {
namespace {

TEST(MeshFiles, AreKnownByTheirExtension) {
    for (const char* name : {"a.obj", "A.PLY", "a.off", "a.STL", "a.b.ply.gz", "a.obj.GZ"})
        EXPECT_TRUE(is_mesh_file(name)) << name;
    for (const char* name : {"a.glb", "obj", "a.gz", "a.obj.zip", "", ".obj"}) EXPECT_FALSE(is_mesh_file(name)) << name;
    EXPECT_THROW(static_cast<void>(read_mesh("a.glb")), Error);
}

/// Real models with what is known about them. HACHURE_MODELS is the folder that holds them.
class RealModels : public testing::Test {
protected:
    void SetUp() override {
        folder_ = test::given_models();
        if (folder_.empty()) GTEST_SKIP() << test::no_given_models;
    }
    std::optional<Primitive> read(const char* name) const {
        if (!std::filesystem::exists(folder_ / name)) return std::nullopt;
        const Model model = read_mesh(folder_ / name);
        Primitive all; // of all meshes and materials together
        for (const Mesh& mesh : model.meshes)
            for (const Primitive& p : mesh.primitives) {
                const auto first = static_cast<std::uint32_t>(all.positions.size());
                all.positions.insert(all.positions.end(), p.positions.begin(), p.positions.end());
                for (const std::uint32_t i : p.indices) all.indices.push_back(first + i);
            }
        return all;
    }

private:
    std::filesystem::path folder_;
};

struct Known {
    const char* name;
    std::uint32_t triangles, vertices, boundary_edges, non_manifold_edges, components;
};

TEST_F(RealModels, AreWhatTheyAreKnownToBe) {
    const Known known[] = {
        {"meshes/nefertiti-lowres.obj", 70000, 35002, 0, 0, 1},
        {"meshes/spot.obj", 23062, 11533, 0, 0, 1},
        {"meshes/torus.obj", 4608, 2304, 0, 0, 1},
        {"meshes/sphere.obj", 1280, 642, 0, 0, 1},
        {"meshes/LeePerrySmith.obj", 17684, 8844, 0, 0, 1},
        {"mechanical/wingnut.obj", 6090, 3047, 0, 0, 1},
        {"mechanical/trimesh/featuretype.STL", 3476, 2010, 576, 0, 1},
        {"mechanical/trimesh/plate_holes.STL", 1252, 618, 0, 0, 1},
        {"mechanical/trimesh/angle_block.STL", 704, 398, 166, 0, 1},
        {"mechanical/trimesh/octagonal_pocket.ply", 3262, 1658, 54, 0, 2},
        {"broken/plane_holes.obj", 16747, 8519, 341, 0, 1},
        {"broken/nonmanifold/fan3.obj", 3, 5, 6, 1, 1},
        {"broken/nonmanifold/triple_vierbein.obj", 108, 75, 60, 20, 1},
        {"broken/nonmanifold/hourglass_ico.obj", 40, 23, 0, 0, 1},
        {"broken/nonmanifold/platonic_shelf.obj", 80, 50, 0, 0, 5},
        {"broken/nonmanifold/moebius.obj", 448, 280, 112, 0, 1},
        {"broken/manifold/self_intersectA.obj", 17160, 8582, 0, 0, 1},
        {"broken/manifold/Havocglass8_left.obj", 164, 84, 0, 0, 1},
    };
    for (const Known& k : known) {
        const auto mesh = read(k.name);
        if (!mesh) continue;
        const geometry::MeshHealth health = geometry::inspect(mesh->positions, mesh->indices);
        EXPECT_EQ(health.triangles, k.triangles) << k.name;
        EXPECT_EQ(health.vertices, k.vertices) << k.name;
        EXPECT_EQ(health.boundary_edges, k.boundary_edges) << k.name;
        EXPECT_EQ(health.non_manifold_edges, k.non_manifold_edges) << k.name;
        EXPECT_EQ(health.components, k.components) << k.name;
        const bool hourglass = std::string_view(k.name).ends_with("hourglass_ico.obj");
        const bool moebius = std::string_view(k.name).ends_with("moebius.obj");
        if (hourglass) {
            EXPECT_EQ(health.non_manifold_vertices, 1u);
        }
        EXPECT_EQ(health.non_orientable_pieces, moebius ? 1u : 0u) << k.name;
    }
}

TEST_F(RealModels, TheDragonIsClosedOnceItsSeamsAreWelded) {
    const auto mesh = read("meshes/stanford-dragon/dragon_vrip.ply.gz");
    if (!mesh) GTEST_SKIP() << "no dragon there";
    EXPECT_EQ(mesh->positions.size(), 437645u);
    const geometry::MeshHealth welded = geometry::inspect(mesh->positions, mesh->indices);
    EXPECT_EQ(welded.triangles, 871414u);
    EXPECT_EQ(welded.degenerate_triangles, 108u);
    EXPECT_EQ(welded.boundary_edges, 0u);
    EXPECT_EQ(welded.components, 1u);
    // The file itself connects less: with every vertex at a place of its own it is in pieces.
    std::vector<glm::vec3> apart(mesh->positions.size());
    for (std::size_t v = 0; v < apart.size(); ++v) apart[v] = {static_cast<float>(v), 0.0f, 0.0f};
    const geometry::MeshHealth file = geometry::inspect(apart, mesh->indices);
    EXPECT_EQ(file.boundary_edges, 4270u);
    EXPECT_EQ(file.components, 151u);
}

TEST_F(RealModels, DecimatedDragonsKeepTheirNonManifoldEdges) {
    const std::tuple<const char*, std::size_t, std::uint32_t> known[] = {
        {"meshes/stanford-dragon/dragon_vrip_res2.ply.gz", 2534, 43},
        {"meshes/stanford-dragon/dragon_vrip_res3.ply.gz", 2094, 16},
        {"meshes/stanford-dragon/dragon_vrip_res4.ply.gz", 803, 2},
    };
    for (const auto& [name, non_manifold_edges, isolated] : known) {
        const auto mesh = read(name);
        if (!mesh) continue;
        // The known count is of all triangles as they are; the inspection leaves copies out, which takes some away.
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> uses;
        std::map<std::array<std::uint32_t, 3>, std::size_t> copies;
        for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
            std::array<std::uint32_t, 3> t{mesh->indices[i], mesh->indices[i + 1], mesh->indices[i + 2]};
            std::ranges::rotate(t, std::ranges::min_element(t));
            const bool is_first = copies[t]++ == 0;
            for (std::size_t k = 0; k < 3; ++k) uses[std::minmax(t[k], t[(k + 1) % 3])] += is_first ? 1 : 1000;
        }
        std::size_t all = 0, without_copies = 0;
        for (const auto& [edge, count] : uses) {
            all += count / 1000 + count % 1000 > 2 ? 1 : 0;
            without_copies += count % 1000 > 2 ? 1 : 0;
        }
        const geometry::MeshHealth health = geometry::inspect(mesh->positions, mesh->indices);
        EXPECT_EQ(all, non_manifold_edges) << name;
        EXPECT_EQ(health.non_manifold_edges, without_copies) << name;
        EXPECT_EQ(health.isolated_vertices, isolated) << name;
        EXPECT_EQ(health.boundary_edges, 0u) << name;
    }
}

TEST_F(RealModels, NoEdgeOfTheFinsOfADecimatedDragonIsLost) {
    const auto mesh = read("meshes/stanford-dragon/dragon_vrip_res4.ply.gz");
    if (!mesh) GTEST_SKIP() << "no dragon there";
    const geometry::EdgeTable table = geometry::build_edge_table(mesh->positions, mesh->indices);
    std::vector<bool> seen(mesh->indices.size() / 3, false);
    for (const geometry::Edge& edge : table.edges) {
        seen[edge.face0] = true;
        if (edge.face1 != geometry::no_face) seen[edge.face1] = true;
    }
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(seen, false)),
              table.dropped_duplicate + table.dropped_degenerate);
}

} // namespace
} // namespace hachure::assets
