#include <hachure/components/edge_lines.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace hachure::test {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr Canvas canvas{256, 192};

/// How much of each pixel black lines cover, for white surfaces on a white ground.
struct Coverage {
    std::vector<float> values;

    [[nodiscard]] double at(int column, int row) const {
        if (column < 0 || row < 0 || column >= canvas.width || row >= canvas.height) return 0.0;
        return static_cast<double>(values[static_cast<std::size_t>(row * canvas.width + column)]);
    }
    [[nodiscard]] double at(const dvec2& pixel) const {
        return at(static_cast<int>(std::floor(pixel.x)), static_cast<int>(std::floor(pixel.y)));
    }
};

struct Drawing {
    Camera camera{.projection = Projection::orthographic, .ymag = 1.5f, .zfar = 100.0f};
    Transform camera_place{.translation = {0, 0, 10}};
    EdgeLines lines{.visibility = LineVisibility::depth}; // line_looks_gl_test.cpp has both
    SurfaceMaterial material{.double_sided = true};
};

Coverage draw(gpu::Context& context, const Drawing& drawing, SurfaceMesh mesh, const Transform& place = {}) {
    DrawnScene scene(context, canvas);
    scene.world().add(scene.add(std::move(mesh), place), drawing.lines);
    scene.add(drawing.camera, drawing.camera_place);
    scene.renderer().request_aov("color");
    scene.renderer().render_frame();
    const assets::Image color = scene.renderer().read_aov("color");
    Coverage coverage;
    for (int i = 0; i < canvas.width * canvas.height; ++i) coverage.values.push_back(1.0f - color.f32()[3 * i]);
    return coverage;
}

/// Where a point of the world is in the picture, pixels from its upper left corner.
dvec2 project(const Drawing& drawing, const dvec3& world) {
    const dvec3 p =
        glm::inverse(glm::dquat(drawing.camera_place.rotation)) * (world - dvec3(drawing.camera_place.translation));
    const bool perspective = drawing.camera.projection == Projection::perspective;
    const double half = perspective ? -p.z * std::tan(0.5 * double(drawing.camera.yfov)) : double(drawing.camera.ymag);
    const double pixels = 0.5 * canvas.height / half;
    return {0.5 * canvas.width + pixels * p.x, 0.5 * canvas.height - pixels * p.y};
}

double distance_to_segment(const dvec2& p, const dvec2& a, const dvec2& b) {
    const double t = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + t * (b - a));
}

/// The picture reached from its border over pixels that lines cover less than half, through corners too.
std::vector<bool> reached_from_outside(const Coverage& coverage) {
    std::vector<bool> reached(coverage.values.size(), false);
    std::vector<std::pair<int, int>> pending{{0, 0}};
    while (!pending.empty()) {
        const auto [x, y] = pending.back();
        pending.pop_back();
        if (x < 0 || y < 0 || x >= canvas.width || y >= canvas.height || coverage.at(x, y) >= 0.5) continue;
        const auto i = static_cast<std::size_t>(y * canvas.width + x);
        if (reached[i]) continue;
        reached[i] = true;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) pending.emplace_back(x + dx, y + dy);
    }
    return reached;
}

using EdgeLinesTest = GlTest;

struct CubeEdge {
    dvec2 start, end;
    bool visible;
};

/// The twelve edges of a cube of size 1 and whether the eye sees one of their two faces.
std::vector<CubeEdge> cube_edges(const Drawing& drawing) {
    std::vector<CubeEdge> edges;
    const dvec3 eye(drawing.camera_place.translation),
        gaze = glm::dquat(drawing.camera_place.rotation) * dvec3(0, 0, -1);
    const auto seen = [&](const dvec3& normal) {
        const bool perspective = drawing.camera.projection == Projection::perspective;
        return glm::dot(normal, perspective ? eye - 0.5 * normal : -gaze) > 0.0;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const double s : {-1.0, 1.0})
            for (const double t : {-1.0, 1.0}) {
                dvec3 along(0.0), side1(0.0), side2(0.0);
                along[axis] = 0.5;
                side1[(axis + 1) % 3] = s;
                side2[(axis + 2) % 3] = t;
                const dvec3 middle = 0.5 * (side1 + side2);
                edges.push_back(
                    {project(drawing, middle - along), project(drawing, middle + along), seen(side1) || seen(side2)});
            }
    return edges;
}

TEST_P(EdgeLinesTest, ACubeShowsItsVisibleEdgesWholeAndNoOthers) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic})
        for (const float turn : {0.3f, 0.8f, 2.5f, 4.4f})
            for (const float tilt : {-0.9f, -0.35f, 0.5f}) {
                SCOPED_TRACE(testing::Message()
                             << "turn " << turn << " tilt " << tilt << " projection " << int(projection));
                Drawing drawing;
                drawing.camera = {.projection = projection, .yfov = 0.5f, .ymag = 1.0f, .zfar = 20.0f};
                drawing.material.double_sided = false;
                drawing.camera_place.rotation =
                    glm::angleAxis(turn, glm::vec3(0, 1, 0)) * glm::angleAxis(tilt, glm::vec3(1, 0, 0));
                drawing.camera_place.translation = drawing.camera_place.rotation * glm::vec3(0, 0, 4);
                const Coverage coverage = draw(context(), drawing, surface_mesh(geometry::cube(1.0), drawing.material));
                const std::vector<CubeEdge> edges = cube_edges(drawing);
                for (const CubeEdge& edge : edges) {
                    const double length = glm::distance(edge.start, edge.end);
                    for (double t = 0.0; t <= length; t += 1.0) {
                        const dvec2 at = glm::mix(edge.start, edge.end, t / length);
                        if (edge.visible) {
                            ASSERT_GT(coverage.at(at), 0.7) << "gap at " << at.x << ", " << at.y;
                            continue;
                        }
                        double nearest = 1e9;
                        for (const CubeEdge& other : edges)
                            if (other.visible)
                                nearest = std::min(nearest, distance_to_segment(at, other.start, other.end));
                        if (nearest > 3.0) {
                            ASSERT_EQ(coverage.at(at), 0.0) << "hidden line at " << at.x << ", " << at.y;
                        }
                    }
                }
            }
}

/// Over a row, coverage adds up to the width of an upright line; of a slanted one to width / cos.
TEST_P(EdgeLinesTest, LinesAreAsWideAsAskedFor) {
    for (const float turn : {0.0f, 0.2f, 0.6f})
        for (const float width : {0.5f, 1.0f, 1.5f, 2.0f, 3.0f, 5.0f, 8.0f}) {
            Drawing drawing;
            drawing.lines.width = width;
            const glm::quat upright =
                glm::angleAxis(turn, glm::vec3(0, 0, 1)) * glm::angleAxis(1.5707963f, glm::vec3(1, 0, 0));
            const Coverage coverage =
                draw(context(), drawing, surface_mesh(geometry::plane(3.0, 1), drawing.material),
                     {.translation = {1.5f * std::cos(turn), 1.5f * std::sin(turn), 0}, .rotation = upright});
            double sum = 0.0;
            constexpr int first = 80, last = 112; // far from the corners
            for (int row = first; row < last; ++row)
                for (int column = 0; column < 200; ++column) sum += coverage.at(column, row);
            EXPECT_NEAR(sum / (last - first) * std::cos(double(turn)), double(width), 0.25) << "turned by " << turn;
        }
}

TEST_P(EdgeLinesTest, BordersOfAPlaneAreWholeFromBothSides) {
    for (const float tilt : {0.2f, 1.2f, 2.4f, 4.0f, 5.5f}) {
        Drawing drawing;
        const glm::quat turn =
            glm::angleAxis(0.4f, glm::vec3(0, 0, 1)) * glm::angleAxis(tilt + 1.5707963f, glm::vec3(1, 0, 0));
        const Coverage coverage =
            draw(context(), drawing, surface_mesh(geometry::plane(1.6, 4), drawing.material), {.rotation = turn});
        for (int side = 0; side < 4; ++side)
            for (double t = -0.8; t <= 0.8; t += 0.01) {
                dvec3 p(t, 0.0, side < 2 ? 0.8 : -0.8);
                if (side % 2 == 1) std::swap(p.x, p.z);
                const dvec2 at = project(drawing, glm::dquat(turn) * p);
                ASSERT_GT(coverage.at(at), 0.7) << "tilt " << tilt << ", gap at " << at.x << ", " << at.y;
            }
        const dvec2 middle = project(drawing, dvec3(0.0));
        if (std::abs(std::cos(tilt)) > 0.3) {
            EXPECT_EQ(coverage.at(middle), 0.0) << "a line inside the plane";
        }
    }
}

/// Every triangle with vertices of its own, as hard edges and formats without indices have them.
SurfaceMesh split(const geometry::Shape& shape, const SurfaceMaterial& material) {
    geometry::Shape result;
    for (const std::uint32_t i : shape.indices) {
        result.indices.push_back(static_cast<std::uint32_t>(result.positions.size()));
        result.positions.push_back(shape.positions[i]);
    }
    for (std::size_t i = 0; i < result.positions.size(); i += 3)
        result.normals.insert(result.normals.end(), 3,
                              glm::normalize(glm::cross(result.positions[i + 1] - result.positions[i],
                                                        result.positions[i + 2] - result.positions[i])));
    return surface_mesh(result, material);
}

/// A wide outline that nothing leaks through: all the pixels of the sphere well inside it stay unreached.
void expect_closed_outline(const Coverage& coverage, const Drawing& drawing, const dvec3& center, double radius) {
    const dvec2 middle = project(drawing, center);
    const dvec3 right = glm::dquat(drawing.camera_place.rotation) * dvec3(1, 0, 0);
    const double pixels = glm::distance(middle, project(drawing, center + radius * right));
    const std::vector<bool> reached = reached_from_outside(coverage);
    int inside = 0, leaked = 0;
    for (int row = 0; row < canvas.height; ++row)
        for (int column = 0; column < canvas.width; ++column) {
            if (glm::distance(dvec2(column + 0.5, row + 0.5), middle) > 0.8 * pixels) continue;
            ++inside;
            leaked += reached[static_cast<std::size_t>(row * canvas.width + column)] ? 1 : 0;
        }
    EXPECT_GT(inside, 1000);
    EXPECT_EQ(leaked, 0);
    EXPECT_TRUE(reached[static_cast<std::size_t>(canvas.width * canvas.height - 1)]);
}

TEST_P(EdgeLinesTest, TheOutlineOfASphereIsClosedHoweverItIsMeshed) {
    const std::vector<std::pair<const char*, geometry::Shape>> spheres = {
        {"icosphere 2", geometry::icosphere(1.0, 2)},
        {"icosphere 3", geometry::icosphere(1.0, 3)},
        {"icosphere 5", geometry::icosphere(1.0, 5)},
        {"coarse meridians", geometry::uv_sphere(1.0, 16, 9)},
        {"fine meridians", geometry::uv_sphere(1.0, 90, 60)}};
    for (const auto& [name, shape] : spheres)
        for (const Projection projection : {Projection::perspective, Projection::orthographic})
            for (const int kind : {0, 1, 2}) {
                SCOPED_TRACE(testing::Message() << name
                                                << (kind == 1   ? ", split"
                                                    : kind == 2 ? ", no normals"
                                                                : "")
                                                << ", projection " << int(projection));
                Drawing drawing;
                drawing.camera = {.projection = projection, .yfov = 0.4f, .ymag = 1.4f, .zfar = 20.0f};
                drawing.camera_place.rotation = glm::angleAxis(0.3f, glm::vec3(0.6f, 0.8f, 0.0f));
                drawing.camera_place.translation = drawing.camera_place.rotation * glm::vec3(0.1f, -0.1f, 7.0f);
                drawing.lines.crease = false;
                SurfaceMesh mesh = kind == 1 ? split(shape, drawing.material) : surface_mesh(shape, drawing.material);
                if (kind == 2) mesh.normals.clear();
                expect_closed_outline(draw(context(), drawing, std::move(mesh)), drawing, dvec3(0.0), 1.0);
            }
}

/// The flood fill must be able to fail.
TEST_P(EdgeLinesTest, WithoutSilhouettesTheOutlineIsOpen) {
    Drawing drawing;
    drawing.lines.silhouette = false;
    drawing.lines.crease = false;
    const Coverage coverage = draw(context(), drawing, surface_mesh(geometry::icosphere(1.0, 3), drawing.material));
    EXPECT_TRUE(
        reached_from_outside(coverage)[static_cast<std::size_t>(canvas.height / 2 * canvas.width + canvas.width / 2)]);
}

TEST_P(EdgeLinesTest, MaterialSeamsAreNoLines) {
    Drawing drawing;
    const SurfaceMesh whole = surface_mesh(geometry::icosphere(1.0, 3), drawing.material);
    SurfaceMesh cut = split(geometry::icosphere(1.0, 3), drawing.material);
    const auto count = static_cast<std::uint32_t>(cut.indices.size());
    const std::uint32_t half = count / 6 * 3;
    SurfaceMaterial other = drawing.material;
    other.name = "other";
    cut.submeshes = {{0, half, drawing.material}, {half, count - half, other}};
    const Coverage a = draw(context(), drawing, whole), b = draw(context(), drawing, cut);
    int different = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) different += std::abs(a.values[i] - b.values[i]) > 0.02f ? 1 : 0;
    EXPECT_EQ(different, 0);
}

/// A line on the far side of another surface is hidden; one in front of it is not.
TEST_P(EdgeLinesTest, SurfacesHideTheLinesBehindThem) {
    for (const float wall_at : {1.0f, -1.0f}) {
        DrawnScene scene(context(), canvas);
        Drawing drawing;
        const glm::quat upright = glm::angleAxis(1.5707963f, glm::vec3(1, 0, 0));
        scene.world().add(scene.add(surface_mesh(geometry::cube(1.0), drawing.material)), EdgeLines{});
        scene.add(surface_mesh(geometry::plane(20.0, 1), drawing.material),
                  {.translation = {0, 0, wall_at}, .rotation = upright});
        scene.add(drawing.camera, drawing.camera_place);
        const assets::Image picture = scene.draw();
        const int dark = static_cast<int>(std::count_if(picture.u8(), picture.u8() + canvas.width * canvas.height * 3,
                                                        [](std::uint8_t v) { return v < 128; }));
        if (wall_at > 0.5f) {
            EXPECT_EQ(dark, 0);
        } else {
            EXPECT_GT(dark, 3 * 4 * 60); // four sides of 64 pixels
        }
    }
}

HACHURE_INSTANTIATE_GL_TESTS(EdgeLinesTest);

} // namespace
} // namespace hachure::test
