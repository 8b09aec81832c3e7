#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/creases.h>
#include <hachure/runtime/geometry/select_edges_by_tree.h>
#include <hachure/tests/support/given_models.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "line_mesh.h"
#include "reference.h"

// The sets of edges against every edge of the mesh tested by its definition, in double precision.

namespace hachure::geometry {
namespace {

using reference::LineMesh;
using Places = std::pair<std::uint32_t, std::uint32_t>;

constexpr float crease_angle = 0.7f;

/// A triangle at an edge, and whether it runs along it upwards.
using Uses = std::vector<std::pair<std::uint32_t, bool>>;

/// All edges with their triangles. Triangles with two corners at one place or no area at all have no side and no part
/// in it, nor has one on the same three places as another one.
std::map<Places, Uses> all_edges(const LineMesh& mesh) {
    std::set<std::array<std::uint32_t, 3>> seen;
    std::vector<bool> left_out(mesh.indices.size() / 3);
    for (std::size_t f = 0; f < left_out.size(); ++f) {
        std::array<std::uint32_t, 3> places;
        for (std::size_t k = 0; k < 3; ++k) places[k] = mesh.weld[mesh.indices[3 * f + k]];
        std::ranges::sort(places);
        left_out[f] = places[0] == places[1] || places[1] == places[2] || !seen.insert(places).second;
    }
    std::map<Places, Uses> result;
    for (const auto& [places, uses] : reference::edges(mesh.positions, mesh.indices))
        for (const auto& use : uses)
            if (!left_out[use.first]) result[places].push_back(use);
    return result;
}

struct Score {
    std::size_t right = 0, missed = 0, wrong = 0;

    void add(const std::set<Places>& got, const std::set<Places>& expected) {
        for (const Places& edge : got) ++(expected.contains(edge) ? right : wrong);
        for (const Places& edge : expected)
            if (!got.contains(edge)) ++missed;
    }
    void add(const Score& other) {
        right += other.right;
        missed += other.missed;
        wrong += other.wrong;
    }
    double precision() const { return right + wrong == 0 ? 1.0 : double(right) / double(right + wrong); }
    double recall() const { return right + missed == 0 ? 1.0 : double(right) / double(right + missed); }
};

using ScoreOfKind = std::map<LineKind, Score>;

class Scores {
public:
    explicit Scores(LineMesh mesh) : mesh_(std::move(mesh)), edges_(all_edges(mesh_)) {
        for (std::size_t f = 0; f < mesh_.indices.size() / 3; ++f) {
            const glm::dvec3 n = reference::area_normal(mesh_.positions, mesh_.indices, f);
            normals_.push_back(n / std::max(glm::length(n), 1e-300));
        }
        tree_ = edge_tree(mesh_.table.edges, mesh_.planes);
    }

    /// Silhouettes from many eyes; with the kinds that do not depend on them.
    ScoreOfKind run() {
        const std::vector<std::uint8_t> creases =
            find_creases(mesh_.positions, mesh_.table.edges, mesh_.planes, crease_angle, 0.0f);
        std::vector<std::uint8_t> materials;
        if (!mesh_.face_materials.empty()) materials = find_material_edges(mesh_.table.edges, mesh_.face_materials);
        const std::vector<ChosenEdge> features = feature_edges(mesh_.table.edges, creases, materials);
        SelectEdgesByTreeJob job{
            .edges = mesh_.table.edges, .planes = mesh_.planes, .features = features, .tree = &tree_};
        ScoreOfKind scores;
        const Bounds bounds = bounds_of(mesh_.positions);
        std::mt19937 random(8);
        std::normal_distribution<float> normal;
        for (int i = 0; i < 24; ++i) {
            const glm::vec3 direction = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
            const float distance = bounds.radius() * (1.2f + 0.2f * static_cast<float>(i));
            const glm::vec4 eye =
                i % 3 == 0 ? glm::vec4(direction, 0.0f) : glm::vec4(bounds.center() + distance * direction, 1.0f);
            job.eye = eye;
            job.run();
            scores[line_silhouette].add(chosen(job, line_silhouette), silhouettes(glm::dvec4(eye)));
        }
        for (const LineKind kind : {line_crease, line_border, line_material})
            scores[kind].add(chosen(job, kind), expected(kind));
        return scores;
    }

private:
    std::set<Places> chosen(const SelectEdgesByTreeJob& job, LineKind kind) const {
        std::set<Places> result;
        for (const ChosenEdge& edge : job.chosen)
            if ((edge.kinds & kind) != 0)
                result.insert(std::minmax({mesh_.table.edges[edge.edge].v0, mesh_.table.edges[edge.edge].v1}));
        return result;
    }
    bool is_front(std::uint32_t face, const glm::dvec4& eye) const {
        const glm::dvec3 corner(mesh_.positions[mesh_.indices[3 * face]]);
        return glm::dot(normals_[face], glm::dvec3(eye) - eye.w * corner) > 0.0;
    }
    /// Calls `test(first triangle, other one, whether their sides disagree)` for the pairs at each edge: it is in the
    /// set when one pair passes.
    template <class Test> std::set<Places> pairs_that(Test&& test) const {
        std::set<Places> result;
        for (const auto& [places, uses] : edges_)
            for (std::size_t i = 1; i < uses.size(); ++i)
                if (test(uses[0].first, uses[i].first, uses[0].second == uses[i].second)) result.insert(places);
        return result;
    }
    std::set<Places> silhouettes(const glm::dvec4& eye) const {
        return pairs_that([&](std::uint32_t a, std::uint32_t b, bool disagree) {
            return is_front(a, eye) != (is_front(b, eye) != disagree);
        });
    }
    std::set<Places> expected(LineKind kind) const {
        if (kind == line_crease)
            return pairs_that([&](std::uint32_t a, std::uint32_t b, bool disagree) {
                const glm::dvec3 other = disagree ? -normals_[b] : normals_[b];
                const double angle =
                    std::atan2(glm::length(glm::cross(normals_[a], other)), glm::dot(normals_[a], other));
                return angle > static_cast<double>(crease_angle);
            });
        if (kind == line_material)
            return pairs_that([&](std::uint32_t a, std::uint32_t b, bool) {
                return !mesh_.face_materials.empty() && mesh_.face_materials[a] != mesh_.face_materials[b];
            });
        std::set<Places> borders;
        for (const auto& [places, uses] : edges_)
            if (uses.size() == 1) borders.insert(places);
        return borders;
    }

    LineMesh mesh_;
    std::map<Places, Uses> edges_;
    std::vector<glm::dvec3> normals_;
    PlaneTree tree_;
};

void expect_right(const ScoreOfKind& scores, const std::string& name) {
    for (const auto& [kind, score] : scores) {
        SCOPED_TRACE(testing::Message() << name << ", kind " << kind << ": " << score.right << " right, " << score.wrong
                                        << " wrong, " << score.missed << " missed");
        EXPECT_GE(score.precision(), 0.999);
        EXPECT_GE(score.recall(), 0.999);
        const std::string key = name + "_kind" + std::to_string(static_cast<int>(kind));
        testing::Test::RecordProperty(key, std::to_string(score.precision()) + " " + std::to_string(score.recall()) +
                                               " of " + std::to_string(score.right + score.missed));
    }
}

void expect_right(LineMesh mesh, const std::string& name) { expect_right(Scores(std::move(mesh)).run(), name); }

/// All meshes of a file, each for itself.
void expect_right(const std::filesystem::path& file, const std::string& name) {
    ScoreOfKind sum;
    for (const assets::Mesh& mesh : assets::read_model(file).meshes)
        for (const auto& [kind, score] : Scores(LineMesh(mesh)).run()) sum[kind].add(score);
    expect_right(sum, name);
}

TEST(EdgeSets, AreRightOnShapes) {
    expect_right(LineMesh(icosphere(1.0, 4)), "icosphere");
    expect_right(LineMesh(irregular_torus(1.0, 0.4, 60, 30, 0.4, 5)), "torus");
    expect_right(LineMesh(cube(1.0)), "cube");
    expect_right(LineMesh(cylinder(1.0, 2.0, 40)), "cylinder");
    expect_right(LineMesh(plane(1.0, 9)), "plane");
}

TEST(EdgeSets, MaterialsMeetAlongEdges) {
    LineMesh mesh(irregular_torus(1.0, 0.4, 60, 30, 0.4, 5));
    for (std::size_t f = 0; f < mesh.indices.size() / 3; ++f)
        mesh.face_materials.push_back(mesh.positions[mesh.indices[3 * f]].x > 0.3f ? 1u : 0u);
    const std::vector<std::uint8_t> marks = find_material_edges(mesh.table.edges, mesh.face_materials);
    EXPECT_GT(std::ranges::count(marks, 1), 40);
    expect_right(std::move(mesh), "two_materials");
}

TEST(EdgeSets, AreRightOnTheBunny) {
    const char* file = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "glmark2-data is not installed";
    expect_right(std::filesystem::path(file), "bunny");
}

TEST(EdgeSets, AreRightOnTheEngine) {
    const char* file = "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "assimp-testmodels is not installed";
    expect_right(std::filesystem::path(file), "engine");
}

class EdgeSetsOfModels : public test::GivenModelTest {};

TEST_P(EdgeSetsOfModels, AreRight) { expect_right(file(), "given"); }

INSTANTIATE_TEST_SUITE_P(Given, EdgeSetsOfModels,
                         testing::Values("mechanical/wingnut.obj", "mechanical/trimesh/featuretype.STL",
                                         "mechanical/CesiumMilkTruck.glb"),
                         test::given_model_name);

} // namespace
} // namespace hachure::geometry
