#include <hachure/components/edge_lines.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/model/spawn_model.h>

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "../../support/drawn_scene.h"
#include "../../support/exact_lines.h"
#include "../../support/gl_fixture.h"

// Drawn lines are where the exactly clipped ones are, within a pixel both ways (symmetric Hausdorff distance).
namespace hachure::test {
namespace {

constexpr Canvas canvas{400, 300};
constexpr int views = 64;

/// Directions evenly over the sphere (a Fibonacci spiral), and a roll of its own for each.
Transform camera_place(int index, const glm::vec3& center, float distance) {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double y = 1.0 - 2.0 * (index + 0.5) / views, angle = golden * index;
    const float tilt = static_cast<float>(-std::asin(y));
    const glm::quat turn = glm::angleAxis(static_cast<float>(angle), glm::vec3(0, 1, 0)) *
                           glm::angleAxis(tilt, glm::vec3(1, 0, 0)) *
                           glm::angleAxis(0.1f * static_cast<float>(index), glm::vec3(0, 0, 1));
    return {.translation = center + turn * glm::vec3(0, 0, distance), .rotation = turn};
}

struct Sweep {
    double worst_missing = 0.0, worst_extra = 0.0;
    std::size_t points = 0, pixels = 0, missing = 0, extra = 0;
};

void measure(const std::filesystem::path& file, LineVisibility visibility) {
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
    std::string reason;
    gpu::Context* context = GlContexts::use(gpu::Backend::egl, reason);
    if (!context) GTEST_SKIP() << "no EGL context: " << reason;
    DrawnScene scene(*context, canvas);
    const SpawnedModel spawned = spawn_model(scene.world(), assets::read_model(file));
    for (const Entity entity : spawned.surfaces)
        scene.world().add(entity, EdgeLines{.width = 1.0f, .visibility = visibility});
    for (const Entity camera : spawned.cameras) scene.world().remove<Camera>(camera);
    geometry::Bounds bounds;
    for (const glm::vec3& p : spawned.points) bounds.include(p);
    const float distance = bounds.radius() / std::sin(0.3f);
    const Entity camera = scene.add(Camera{.yfov = 0.6f, .znear = 0.05f * distance}, {});
    scene.renderer().request_aov("line_layer");
    const char* only = std::getenv("HACHURE_LINE_VIEW");
    std::unique_ptr<ExactLineFinder> finder;
    Sweep sweep;
    for (int view = only ? std::atoi(only) : 0; view < (only ? std::atoi(only) + 1 : views); ++view) {
        scene.world().get_mutable<Transform>(camera) = camera_place(view, bounds.center(), distance);
        scene.renderer().render_frame();
        if (!finder)
            finder = std::make_unique<ExactLineFinder>(scene.world().resource<DrawList>(),
                                                       scene.world().resource<MeshStore>(), 1.1);
        const std::string cache = "/tmp/e2-cache-" + file.stem().string() + "-" + std::to_string(view);
        ExactLines exact;
        if (FILE* f = std::fopen(cache.c_str(), "rb")) {
            std::size_t n[2];
            (void)!fread(n, 8, 2, f);
            exact.seen.resize(n[0]); exact.allowed.resize(n[1]);
            (void)!fread(exact.seen.data(), 16, n[0], f); (void)!fread(exact.allowed.data(), 16, n[1], f);
            fclose(f);
        } else {
            exact = finder->find(scene.world().resource<View>());
            f = std::fopen(cache.c_str(), "wb");
            std::size_t n[2] = {exact.seen.size(), exact.allowed.size()};
            fwrite(n, 8, 2, f); fwrite(exact.seen.data(), 16, n[0], f); fwrite(exact.allowed.data(), 16, n[1], f);
            fclose(f);
        }
        const LineDistance d = compare_lines(scene.renderer().read_aov("line_layer"), exact);
        std::printf("view %2d: length %7.0f missing %.2f (%zu of %zu) at %.1f %.1f, extra %.2f (%zu of %zu) at %.1f %.1f\n",
                    view, exact.length, d.missing, d.missing_points, d.points, d.worst_missing.x, d.worst_missing.y,
                    d.extra, d.extra_pixels, d.pixels, d.worst_extra.x, d.worst_extra.y);
        if (only) finder->explain(scene.world().resource<View>(), d.worst_extra);
        sweep.worst_missing = std::max(sweep.worst_missing, d.missing);
        sweep.worst_extra = std::max(sweep.worst_extra, d.extra);
        sweep.points += d.points, sweep.pixels += d.pixels, sweep.missing += d.missing_points,
            sweep.extra += d.extra_pixels;
    }
    std::printf("all: missing %.2f (%zu of %zu) extra %.2f (%zu of %zu)\n", sweep.worst_missing, sweep.missing,
                sweep.points, sweep.worst_extra, sweep.extra, sweep.pixels);
    EXPECT_LE(sweep.worst_missing, 1.0);
    EXPECT_LE(sweep.worst_extra, 1.0);
}

constexpr const char* engine = "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb";
constexpr const char* bunny = "/usr/share/glmark2/models/bunny.obj";

TEST(LineDistance, OfTheEngineByDepth) { measure(engine, LineVisibility::depth); }
TEST(LineDistance, OfTheEngineClipped) { measure(engine, LineVisibility::exact); }
TEST(LineDistance, OfTheBunnyClipped) { measure(bunny, LineVisibility::exact); }
TEST(LineDistance, OfTheBunnyByDepth) { measure(bunny, LineVisibility::depth); }

} // namespace
} // namespace hachure::test
