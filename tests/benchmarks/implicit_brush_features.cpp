#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/gpu/gl.h>
#include <hachure/systems/implicit_brush/widen_job.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/benchmarks/implicit_brush_features.h>
#include <hachure/tests/support/feature_scene.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace hachure::bench {
namespace {

/// A model's depth and normals as a frame has them, and where it is.
struct Geometry {
    std::uint32_t depth = 0, normals = 0; ///< of the frame graph's back end
    gpu::Rect rect;
    double covered = 0.0; ///< of the view
};

SpawnedModel spawn(World& world, const std::filesystem::path& path, bool quick) {
    if (!quick)
        return spawn_model(world, assets::read_model(path.empty() ? "/usr/share/glmark2/models/bunny.obj" : path));
    const geometry::Shape shape = geometry::torus(1.0, 0.4, 48, 24);
    assets::Model model;
    model.meshes.push_back(
        {"torus", {{.positions = shape.positions, .normals = shape.normals, .indices = shape.indices}}, {}});
    model.nodes.push_back({.name = "torus", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return spawn_model(world, model);
}

void aim(test::FeatureScene& scene, const SpawnedModel& model) {
    for (const Entity camera : model.cameras) scene.world().remove<Camera>(camera);
    geometry::Bounds bounds;
    for (const glm::vec3& p : model.points) bounds.include(p);
    const float distance = 0.61f * bounds.radius() / std::sin(0.3f);
    const glm::quat turn = glm::angleAxis(0.4f, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.3f, glm::vec3(1, 0, 0));
    scene.scene().add(Camera{.yfov = 0.6f, .znear = 0.05f * distance},
                      {.translation = bounds.center() + turn * glm::vec3(0.0f, 0.0f, distance), .rotation = turn});
}

/// From the AOVs of a frame back to the buffers that they were made of.
Geometry geometry_of(test::FeatureScene& scene, RenderContext& render) {
    scene.scene().renderer().request_aov("normal");
    scene.scene().renderer().request_aov("depth");
    scene.draw();
    const test::AovPixels depth = scene.aov("depth"), normal = scene.aov("normal");
    const View& view = scene.world().resource<View>();
    std::vector<float> depths, normals;
    glm::ivec2 low(view.width, view.height), high(0);
    int covered = 0;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const float metres = *depth.at(x, y);
            const float* n = normal.at(x, y);
            const bool there = metres < 1e9f;
            const glm::vec4 clip = view.clip_from_view * glm::vec4(0.0f, 0.0f, -metres, 1.0f);
            depths.push_back(there ? clip.z / clip.w : 0.0f);
            normals.insert(normals.end(), {n[0], n[1], n[2], 0.0f});
            if (!there) continue;
            ++covered;
            low = glm::min(low, glm::ivec2(x, y)), high = glm::max(high, glm::ivec2(x + 1, y + 1));
        }
    Geometry made{.covered = double(covered) / (double(view.width) * double(view.height))};
    made.rect = grown({low.x, low.y, high.x - low.x, high.y - low.y}, 12, view);
    made.depth = render.backend->create_texture({view.width, view.height, gpu::Format::depth32f}, "depth");
    made.normals = render.backend->create_texture({view.width, view.height, gpu::Format::rgba32f}, "normals");
    render.backend->texture(made.depth).upload(std::span<const float>(depths), gpu::RowOrder::bottom_first);
    render.backend->texture(made.normals).upload(std::span<const float>(normals), gpu::RowOrder::bottom_first);
    return made;
}

double timed_job(const auto& work) {
    gpu::gl().Finish();
    const double start = now_ms();
    work();
    gpu::gl().Finish();
    return now_ms() - start;
}

} // namespace

double report_features(Report& report, gpu::Context& context, const std::filesystem::path& model, bool quick) {
    const Canvas canvas = quick ? Canvas{64, 48} : Canvas{1024, 768};
    test::FeatureScene scene(context, canvas);
    aim(scene, spawn(scene.world(), model, quick));
    scene.want({.feature = BrushFeature::valleys});
    scene.draw();
    RenderContext& render = scene.world().resource_mutable<RenderContext>();
    const Geometry geometry = geometry_of(scene, render);
    const gpu::Rect rect = geometry.rect, whole{0, 0, canvas.width, canvas.height};
    const auto texture = [&](gpu::Format format) {
        return render.backend->create_texture({canvas.width, canvas.height, format}, "feature");
    };
    const gpu::Format format = gpu::Format::rgba32f; // of quality standard
    const std::uint32_t slopes = texture(format), diffused = texture(format), scratch = texture(format);
    const std::uint32_t data = texture(format), profile = texture(format);
    const std::uint32_t candidates = texture(gpu::Format::depth32f), depth = geometry.depth;
    const std::array floor{texture(gpu::Format::rgba16f), texture(gpu::Format::rgba16f), texture(gpu::Format::rgba16f)};
    render.backend->texture(floor[0]).clear(std::array{0.5f, 0.5f, 0.0f, 1.0f});
    std::vector<double> floors, slope, diffusion, extraction, profiles;
    for (int i = -1; i < (quick ? 1 : 9); ++i) {
        const double times[] = {
            // Two passes of nine fetches each.
            0.5 * timed_job([&] {
                WidenJob{4, floor[0], floor[1], floor[2], whole}.run(render);
            }),
            timed_job([&] {
                SlopeJob{.depth_buffer = depth, .normals = geometry.normals, .rect = rect, .to = slopes}.run(render);
            }),
            timed_job([&] { SlopeDiffusionJob{10, 1, slopes, diffused, scratch, rect, depth}.run(render); }),
            timed_job([&] {
                FeatureDataJob{.feature = BrushFeature::valleys,
                               .slopes = diffused,
                               .scratch = scratch,
                               .to = data,
                               .rect = rect,
                               .depth_buffer = depth}
                    .run(render);
            }),
            timed_job([&] {
                FeatureProfileJob{.taps = 4,
                                  .fits = 3,
                                  .least_height = 0.2f,
                                  .reach = 3.0f,
                                  .data = data,
                                  .candidates = candidates,
                                  .to = profile,
                                  .valid = rect,
                                  .rect = rect}
                    .run(render);
            })};
        if (i < 0) continue; // programs are compiled
        floors.push_back(times[0]), slope.push_back(times[1]), diffusion.push_back(times[2]);
        extraction.push_back(times[3]), profiles.push_back(times[4]);
    }
    const double pass = median(floors);
    report.add("features: part of the view that the model covers", 100.0 * geometry.covered, "%");
    report.add("features: one pass of 9 RGBA16F fetches", pass, "ms");
    report.add("features: slopes / pass of 9 fetches", median(slope) / pass, "ratio");
    report.add("features: 10 steps of diffusion / pass of 9 fetches", median(diffusion) / pass, "ratio");
    report.add("features: heights and directions / pass of 9 fetches", median(extraction) / pass, "ratio");
    report.add("features: profiles / pass of 9 fetches", median(profiles) / pass, "ratio");
    report.add_limited("features: all of that / pass of 9 fetches",
                       (median(slope) + median(diffusion) + median(extraction) + median(profiles)) / pass, "ratio",
                       14.0);
    return pass;
}

} // namespace hachure::bench
