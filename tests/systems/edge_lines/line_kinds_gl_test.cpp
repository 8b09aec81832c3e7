#include <hachure/components/edge_lines.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// Kinds of lines that a scene asks for, each alone, where they must be and nowhere else.
namespace hachure::test {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int size = 200; ///< pixels, both ways

const EdgeLines none{.silhouette = false, .crease = false, .border = false, .width = 2.0f, .color = {1, 0, 0}};

/// A world seen by one camera, in a square picture.
class KindStage {
public:
    KindStage(gpu::Context& context, const dvec3& eye, const dvec3& target, float yfov = 0.6f)
        : scene_(context, {size, size}), eye_(eye),
          look_(glm::quatLookAt(glm::normalize(target - eye),
                                std::abs(target.y - eye.y) > 0.99 * glm::distance(target, eye) ? dvec3(0, 0, -1)
                                                                                               : dvec3(0, 1, 0))),
          pixels_(0.5 * size / std::tan(0.5 * double(yfov))) {
        scene_.add(Camera{.yfov = yfov}, {.translation = glm::vec3(eye), .rotation = glm::quat(look_)});
        scene_.renderer().request_aov("line_layer");
    }

    Entity add(SurfaceMesh mesh, const Transform& place = {}) { return scene_.add(std::move(mesh), place); }
    World& world() { return scene_.world(); }

    void draw() {
        scene_.renderer().render_frame();
        layer_ = scene_.renderer().read_aov("line_layer");
    }

    /// Pixels from the upper left corner.
    dvec2 project(const dvec3& p) const {
        const dvec3 q = glm::inverse(look_) * (p - eye_);
        return {0.5 * size - q.x / q.z * pixels_, 0.5 * size + q.y / q.z * pixels_};
    }

    double at(int column, int row) const {
        if (column < 0 || row < 0 || column >= size || row >= size) return 0.0;
        return double(layer_.f32()[4 * (row * size + column) + 3]);
    }

    /// The most that lines cover of the pixels around a point.
    double near(const dvec2& p) const {
        double most = 0.0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                most =
                    std::max(most, at(static_cast<int>(std::floor(p.x)) + dx, static_cast<int>(std::floor(p.y)) + dy));
        return most;
    }

    /// Pixels with a line that are farther than `reach` from every one of some points.
    int elsewhere(const std::vector<dvec2>& points, double reach) const {
        int count = 0;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column)
                count += at(column, row) > 0.0 && std::ranges::none_of(points, [&](const dvec2& p) {
                             return glm::distance(p, dvec2(column + 0.5, row + 0.5)) <= reach;
                         });
        return count;
    }

private:
    DrawnScene scene_;
    dvec3 eye_;
    glm::dquat look_;
    double pixels_;
    assets::Image layer_;
};

using LineKindsTest = GlTest;

/// A plate of two materials: the line is where they meet, and not where two parts of one material do.
TEST_P(LineKindsTest, AMaterialBoundaryIsDrawnWholeAndOnlyThere) {
    for (const bool asked : {true, false})
        for (const LineVisibility visibility : {LineVisibility::depth, LineVisibility::exact}) {
            KindStage stage(context(), {0.3, 2.5, 2.0}, {0, 0, 0});
            SurfaceMesh plate;
            for (int x = 0; x < 4; ++x) // three strips along z, the first two of one material
                for (const float z : {-0.5f, 0.5f}) plate.positions.emplace_back(0.4f * float(x) - 0.6f, 0.0f, z);
            plate.normals.assign(plate.positions.size(), {0, 1, 0});
            for (std::uint32_t x = 0; x < 3; ++x)
                for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) plate.indices.push_back(2 * x + corner);
            SurfaceMaterial first, second;
            first.name = "first";
            second.name = "second";
            plate.submeshes = {{0, 6, first}, {6, 6, first}, {12, 6, second}};
            const Entity entity = stage.add(std::move(plate));
            EdgeLines lines = none;
            lines.material = asked;
            lines.visibility = visibility;
            lines.suggestive = !asked; // so that something is asked for; a plane has none
            stage.world().add(entity, lines);
            stage.draw();
            std::vector<dvec2> boundary;
            for (double z = -0.5; z <= 0.5; z += 0.01) boundary.push_back(stage.project({0.2, 0.0, z}));
            EXPECT_EQ(stage.elsewhere(boundary, 3.0), 0);
            for (const dvec2& p : boundary) ASSERT_EQ(stage.near(p) > 0.7, asked) << p.x << ", " << p.y;
        }
}

/// A box that stands in the floor up to its middle: the line of contact goes round it, seen where the box does not hide
/// it, whichever of the two asks for it.
TEST_P(LineKindsTest, ABoxThroughAFloorHasALineOfContact) {
    for (const bool floor_asks : {true, false})
        for (const float turn : {0.5f, 0.9f}) {
            SCOPED_TRACE(testing::Message() << "floor asks " << floor_asks << ", turned by " << turn);
            const dvec3 eye(0.4, 2.6, 3.4);
            KindStage stage(context(), eye, {0, 0, 0});
            const Entity floor = stage.add(surface_mesh(geometry::plane(6.0, 3)));
            const glm::quat turned = glm::angleAxis(turn, glm::vec3(0, 1, 0));
            const Entity box = stage.add(surface_mesh(geometry::cube(1.0)), {.rotation = turned});
            EdgeLines asks = none, carries = none;
            asks.intersection = true;
            carries.material = true; // draws nothing, and takes part
            stage.world().add(floor, floor_asks ? asks : carries);
            stage.world().add(box, floor_asks ? carries : asks);
            stage.draw();
            std::vector<dvec2> contact;
            int seen_sides = 0;
            for (int side = 0; side < 4; ++side) {
                const glm::dquat q = glm::dquat(turned) * glm::angleAxis(1.5707963267948966 * side, dvec3(0, 1, 0));
                const dvec3 normal = q * dvec3(0, 0, 1);
                if (glm::dot(normal, eye - 0.5 * normal) <= 0.0) continue;
                ++seen_sides;
                for (double t = -0.5; t <= 0.5; t += 0.005) {
                    contact.push_back(stage.project(q * dvec3(t, 0.0, 0.5)));
                    ASSERT_GT(stage.near(contact.back()), 0.7) << "a gap on side " << side << " at " << t;
                }
            }
            EXPECT_EQ(seen_sides, 2);
            EXPECT_EQ(stage.elsewhere(contact, 3.0), 0) << "a line that is behind the box, or belongs to nothing";
        }
}

/// Waves y = h cos(k z) bend along z alone, so that the curvature towards any eye is none where they turn from hollow
/// to bulging, and grows towards this one where that is on the way to it: k z = -pi/2 + 2 pi n. A ball has none from
/// anywhere.
TEST_P(LineKindsTest, SuggestiveContoursAreWhereAHollowEndsTowardsTheEye) {
    constexpr double height = 0.06, k = 9.0; // less steep than the eye is high: no silhouettes
    geometry::Shape waves = geometry::plane(2.0, 120);
    for (std::size_t i = 0; i < waves.positions.size(); ++i) {
        glm::vec3& p = waves.positions[i];
        p.y = static_cast<float>(height * std::cos(k * double(p.z)));
        waves.normals[i] =
            glm::normalize(glm::vec3(0.0f, 1.0f, static_cast<float>(height * k * std::sin(k * double(p.z)))));
    }
    EdgeLines lines = none;
    lines.suggestive = true;
    KindStage stage(context(), {0, 2.6, 3.4}, {0, 0, 0}, 0.5f);
    const Entity entity = stage.add(surface_mesh(waves));
    stage.world().add(entity, lines);
    stage.draw();
    std::vector<dvec2> contours;
    for (const int n : {-1, 0, 1})
        for (double x = -1.0; x <= 1.0; x += 0.01) {
            contours.push_back(stage.project({x, 0.0, (6.283185307 * n - 1.570796327) / k}));
            if (std::abs(x) < 0.9) {
                ASSERT_GT(stage.near(contours.back()), 0.5) << "of contour " << n << " at " << x;
            }
        }
    EXPECT_EQ(stage.elsewhere(contours, 3.0), 0);

    KindStage ball(context(), {0.5, 1.5, 4.0}, {0, 0, 0}, 0.5f);
    ball.world().add(ball.add(surface_mesh(geometry::icosphere(1.0, 5))), lines);
    ball.draw();
    EXPECT_EQ(ball.elsewhere({}, 0.0), 0);
}

HACHURE_INSTANTIATE_GL_TESTS(LineKindsTest);

} // namespace
} // namespace hachure::test
