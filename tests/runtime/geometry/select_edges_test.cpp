#include <hachure/runtime/geometry/creases.h>
#include <hachure/runtime/geometry/select_edges.h>
#include <hachure/runtime/geometry/shapes.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <tuple>

namespace hachure::geometry {
namespace {

using glm::dvec3;
using Place = std::tuple<float, float, float>;
using PlacePair = std::pair<Place, Place>;

struct Choice {
    bool silhouette = true, crease = true, border = true;
    float crease_angle = 0.9f;

    std::uint32_t kinds() const {
        return (silhouette ? line_silhouette : 0u) | (crease ? line_crease : 0u) | (border ? line_border : 0u);
    }
};

Place place(const glm::vec3& p) { return {p.x, p.y, p.z}; }

PlacePair pair_of(const glm::vec3& a, const glm::vec3& b) { return std::minmax(place(a), place(b)); }

/// Every edge at its two places with the triangles there and whether each runs along it upwards.
std::map<PlacePair, std::vector<std::pair<std::size_t, bool>>> all_edges(const Shape& shape) {
    std::map<PlacePair, std::vector<std::pair<std::size_t, bool>>> edges;
    for (std::size_t f = 0; f < shape.indices.size() / 3; ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 a = shape.positions[shape.indices[3 * f + k]];
            const glm::vec3 b = shape.positions[shape.indices[3 * f + (k + 1) % 3]];
            edges[pair_of(a, b)].emplace_back(f, place(a) < place(b));
        }
    return edges;
}

/// The edges that must be drawn and those that hang on the last bits of a float, by definition and in double precision.
struct Reference {
    std::set<PlacePair> drawn, undecided;
};

Reference reference(const Shape& shape, const glm::dvec4& eye, const Choice& choice) {
    const auto corner = [&](std::size_t f, std::size_t k) { return dvec3(shape.positions[shape.indices[3 * f + k]]); };
    const auto normal = [&](std::size_t f) {
        return glm::normalize(glm::cross(corner(f, 1) - corner(f, 0), corner(f, 2) - corner(f, 0)));
    };
    const auto towards = [&](std::size_t f) { return glm::dot(normal(f), dvec3(eye) - eye.w * corner(f, 0)); };
    Reference result;
    for (const auto& [places, faces] : all_edges(shape)) {
        if (faces.size() == 1) {
            if (choice.border) result.drawn.insert(places);
            continue;
        }
        for (std::size_t other = 1; other < faces.size(); ++other) {
            // Triangles that run along the edge in the same direction disagree about the front: turn one.
            const double turn = faces[0].second == faces[other].second ? -1.0 : 1.0;
            const double first = towards(faces[0].first), second = turn * towards(faces[other].first);
            const double angle =
                std::acos(std::clamp(turn * glm::dot(normal(faces[0].first), normal(faces[other].first)), -1.0, 1.0));
            if (std::min(std::abs(first), std::abs(second)) < 1e-5 ||
                std::abs(angle - double(choice.crease_angle)) < 1e-3)
                result.undecided.insert(places);
            else if ((choice.silhouette && (first > 0.0) != (second > 0.0)) ||
                     (choice.crease && angle > double(choice.crease_angle)))
                result.drawn.insert(places);
        }
    }
    return result;
}

std::set<PlacePair> selected(const Shape& shape, const glm::vec4& eye, const Choice& choice, bool closed = false) {
    const EdgeTable table = build_edge_table(shape.positions, shape.indices);
    std::vector<glm::vec4> planes(shape.indices.size() / 3);
    face_planes(shape.positions, shape.indices, planes);
    // Every edge above the angle: which of them are too short to be drawn is find_creases_test's.
    std::vector<std::uint8_t> creases(table.edges.size());
    for (std::size_t i = 0; i < creases.size(); ++i) {
        const Edge& edge = table.edges[i];
        if (edge.face1 == no_face) continue;
        const float turn = (edge.flags & edge_orientation_mismatch) != 0 ? -1.0f : 1.0f;
        const float cosine = turn * glm::dot(glm::vec3(planes[edge.face0]), glm::vec3(planes[edge.face1]));
        creases[i] = cosine < std::cos(choice.crease_angle) ? 1 : 0;
    }
    std::vector<std::uint8_t> front(planes.size());
    std::vector<ChosenEdge> chosen(table.edges.size());
    const std::vector<ChosenEdge> features = feature_edges(table.edges, creases, {});
    SelectEdgesJob job{.edges = table.edges,
                       .planes = planes,
                       .features = features,
                       .eye = eye,
                       .wanted = choice.kinds(),
                       .closed = closed,
                       .front = front,
                       .chosen = chosen};
    job.validate();
    job.run();
    EXPECT_TRUE(std::ranges::is_sorted(std::span(chosen).first(job.count), std::less_equal(), &ChosenEdge::edge));
    std::set<PlacePair> result;
    for (std::size_t i = 0; i < job.count; ++i) {
        const Edge& edge = table.edges[chosen[i].edge];
        result.insert(pair_of(shape.positions[edge.v0], shape.positions[edge.v1]));
    }
    return result;
}

/// Triangles without any neighbour.
Shape soup(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> at(-1.0f, 1.0f);
    Shape shape;
    for (std::uint32_t i = 0; i < 300; ++i) {
        shape.positions.emplace_back(at(random), at(random), at(random));
        shape.indices.push_back(i);
    }
    return shape;
}

/// Some triangles turned round, some taken away.
Shape battered(Shape shape, std::uint32_t seed, unsigned turned, unsigned lost) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> indices;
    for (std::size_t f = 0; f < shape.indices.size(); f += 3) {
        if (random() % 100 < lost) continue;
        const bool turn = random() % 100 < turned;
        for (const std::size_t k : {0, 1, 2}) indices.push_back(shape.indices[f + (turn ? 2 - k : k)]);
    }
    shape.indices = indices;
    return shape;
}

/// `pages` squares around one spine, all wound alike.
Shape book(int pages) {
    Shape shape;
    for (int i = 0; i < pages; ++i) {
        const float angle = 0.3f + 0.9f * static_cast<float>(i);
        const glm::vec3 out(std::cos(angle), 0.0f, std::sin(angle)), up(0.0f, 1.0f, 0.0f);
        const auto first = static_cast<std::uint32_t>(shape.positions.size());
        for (const glm::vec3& p : {glm::vec3(0.0f), out, out + up, up}) shape.positions.push_back(p);
        for (const std::uint32_t k : {0, 1, 2, 0, 2, 3}) shape.indices.push_back(first + k);
    }
    return shape;
}

std::vector<std::pair<const char*, Shape>> shapes() {
    return {{"icosphere", icosphere(1.0, 3)},
            {"torus", torus(1.0, 0.4, 24, 16)},
            {"irregular torus", irregular_torus(1.0, 0.4, 20, 12, 0.4, 5)},
            {"cube", cube(1.0)},
            {"cone", cone(0.7, 1.3, 17)},
            {"soup", soup(1)},
            {"turned triangles", battered(icosphere(1.0, 3), 2, 30, 0)},
            {"open", battered(torus(1.0, 0.4, 24, 16), 3, 0, 25)},
            {"open with turned triangles", battered(icosphere(1.0, 3), 4, 20, 20)},
            {"book", book(4)}};
}

std::vector<glm::vec4> eyes() {
    std::vector<glm::vec4> result;
    std::mt19937 random(11);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 6; ++i) {
        const glm::vec3 direction = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
        result.emplace_back(direction, 0.0f);
        result.emplace_back((1.7f + static_cast<float>(i)) * direction, 1.0f);
    }
    result.emplace_back(0.1f, 0.2f, -0.05f, 1.0f); // inside
    return result;
}

TEST(SelectEdges, ChoosesWhatTheDefinitionSays) {
    const std::vector<Choice> choices = {{},
                                         {true, false, false},
                                         {false, true, false, 0.2f},
                                         {false, false, true},
                                         {true, true, true, 2.5f},
                                         {false, false, false}};
    for (const auto& [name, shape] : shapes())
        for (const Choice& choice : choices)
            for (const glm::vec4& eye : eyes()) {
                SCOPED_TRACE(testing::Message()
                             << name << ", eye " << eye.x << " " << eye.y << " " << eye.z << " " << eye.w);
                const Reference expected = reference(shape, glm::dvec4(eye), choice);
                std::set<PlacePair> got = selected(shape, eye, choice), wanted = expected.drawn;
                ASSERT_LT(expected.undecided.size(), 20u);
                for (const PlacePair& edge : expected.undecided) {
                    got.erase(edge);
                    wanted.erase(edge);
                }
                ASSERT_EQ(got, wanted);
            }
}

TEST(SelectEdges, AnEvenSurfaceHasNoMoreLinesThanItsSilhouette) {
    const Shape sphere = icosphere(1.0, 4);
    const std::size_t lines = selected(sphere, {0.3f, 2.5f, 1.0f, 1.0f}, {}).size();
    EXPECT_GT(lines, 40u);  // 5120 triangles: a great circle crosses about 100 of them
    EXPECT_LT(lines, 200u); // of 7680 edges
}

TEST(SelectEdges, ACubeFromACornerShowsTwelveEdgesAndNineWhenItIsClosed) {
    const glm::vec4 eye(3.0f, 4.0f, 5.0f, 1.0f);
    EXPECT_EQ(selected(cube(1.0), eye, {}).size(), 12u);
    EXPECT_EQ(selected(cube(1.0), eye, {}, true).size(), 9u);
    EXPECT_EQ(selected(cube(1.0), eye, {true, false, false}, true).size(), 6u);
}

TEST(SelectEdges, ASeamBetweenRepeatedVerticesIsNoLine) {
    const Shape sphere = uv_sphere(1.0, 24, 12);
    EXPECT_TRUE(selected(sphere, {0.0f, 0.0f, 1.0f, 0.0f}, {false, false, true}).empty());
}

TEST(SelectEdges, TheCreaseAngleIsAThreshold) {
    const glm::vec4 eye(3.0f, 4.0f, 5.0f, 1.0f);
    const auto right_angle = static_cast<float>(std::numbers::pi / 2);
    EXPECT_EQ(selected(cube(1.0), eye, {false, true, false, right_angle - 0.01f}).size(), 12u);
    EXPECT_EQ(selected(cube(1.0), eye, {false, true, false, right_angle + 0.01f}).size(), 0u);
}

} // namespace
} // namespace hachure::geometry
