// What drawing edge lines costs, how far they are from where they belong, and how much of them is lost from frame to
// frame while the eye moves by sixteenths of a pixel: lines of the mesh seen by a depth buffer, clipped exactly, and
// lines from the picture. `--chart FILE [--quick]` writes what edge_lines_drawing_chart.gp draws.

#include <hachure/components/edge_lines.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/exact_lines.h>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace hachure;
using bench::now_ms;

constexpr const char* bunny = "/usr/share/glmark2/models/bunny.obj";

struct Method {
    const char* name;
    EdgeLines lines;
};

const std::array<Method, 3> methods = {
    Method{"depth", {.width = 1.0f, .visibility = LineVisibility::depth}},
    Method{"exact", {.width = 1.0f, .visibility = LineVisibility::exact}},
    Method{"image", {.width = 1.0f, .method = LineMethod::image}},
};

assets::Model benchmark_model(const std::filesystem::path& path, bool quick) {
    if (!quick) return assets::read_model(path.empty() ? bunny : path);
    const geometry::Shape shape = geometry::torus(1.0, 0.4, 48, 24);
    assets::Model model;
    model.meshes.push_back(
        {"torus", {{.positions = shape.positions, .normals = shape.normals, .indices = shape.indices}}, {}});
    model.nodes.push_back({.name = "torus", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return model;
}

/// A model with a camera around it.
class Stage {
public:
    Stage(gpu::Context& context, const assets::Model& model, Canvas canvas) : scene_(context, canvas), canvas_(canvas) {
        spawned_ = spawn_model(scene_.world(), model);
        for (const Entity camera : spawned_.cameras) scene_.world().remove<Camera>(camera);
        for (const glm::vec3& p : spawned_.points) bounds_.include(p);
        distance_ = bounds_.radius() / std::sin(0.3f);
        camera_ = scene_.add(Camera{.yfov = 0.6f, .znear = 0.05f * distance_}, {});
        scene_.renderer().request_aov("line_layer");
        turn(0.0f);
    }

    /// Null: no lines at all.
    void draw_with(const EdgeLines* lines) {
        for (const Entity entity : spawned_.surfaces) {
            if (scene_.world().has<EdgeLines>(entity)) scene_.world().remove<EdgeLines>(entity);
            if (lines) scene_.world().add(entity, *lines);
        }
    }

    void turn(float angle) {
        const glm::quat turn = glm::angleAxis(angle, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.3f, glm::vec3(1, 0, 0));
        scene_.world().get_mutable<Transform>(camera_) = {
            .translation = bounds_.center() + turn * glm::vec3(0, 0, distance_), .rotation = turn};
    }

    /// To the right, by pixels at the middle of the model.
    void shift(float pixels) {
        const float metres = 2.0f * distance_ * std::tan(0.3f) / static_cast<float>(canvas_.height);
        Transform& place = scene_.world().get_mutable<Transform>(camera_);
        place.translation = place.translation + place.rotation * glm::vec3(pixels * metres, 0.0f, 0.0f);
    }

    double frame_ms() {
        const double start = now_ms();
        scene_.renderer().render_frame();
        scene_.renderer().finish();
        return now_ms() - start;
    }

    test::LineDistance distance() {
        scene_.renderer().render_frame();
        if (!finder_)
            finder_ = std::make_unique<test::ExactLineFinder>(scene_.world().resource<DrawList>(),
                                                              scene_.world().resource<MeshStore>(), 1.1);
        const View& view = scene_.world().resource<View>();
        if (!(view == view_)) {
            exact_ = finder_->find(view);
            view_ = view;
        }
        return test::compare_lines(scene_.renderer().read_aov("line_layer"), exact_);
    }

    [[nodiscard]] double exact_length() const { return exact_.length; }

private:
    test::DrawnScene scene_;
    Canvas canvas_;
    SpawnedModel spawned_;
    geometry::Bounds bounds_;
    float distance_ = 1.0f;
    Entity camera_;
    std::unique_ptr<test::ExactLineFinder> finder_;
    test::ExactLines exact_;
    View view_;
};

/// What one method costs and is worth.
struct Figures {
    std::vector<double> ms, plain_ms, ratio; ///< per frame: with lines, without, and the one over the other
    double lost = 0.0, extra = 0.0;   ///< shares of lines and of drawn pixels farther than a pixel from the other
    double hausdorff = 0.0;           ///< pixels, LineDistance::most at most
    std::vector<double> lost_by_step; ///< pixels of line, frame by frame
};

void measure_cost(Stage& stage, const Method& method, int frames, Figures& figures) {
    for (int i = -2; i < frames; ++i) {
        stage.turn(0.02f * static_cast<float>(i));
        stage.draw_with(nullptr);
        const double plain = stage.frame_ms();
        stage.turn(0.02f * static_cast<float>(i) + 0.01f);
        stage.draw_with(&method.lines);
        const double lined = stage.frame_ms();
        if (i < 0) continue;
        figures.ms.push_back(lined - plain);
        figures.plain_ms.push_back(plain);
        figures.ratio.push_back(lined / plain);
    }
}

void measure_distance(Stage& stage, int views, std::array<Figures, methods.size()>& figures) {
    std::array<test::LineDistance, methods.size()> sums;
    for (int view = 0; view < views; ++view) {
        stage.turn(6.2831853f * static_cast<float>(view) / static_cast<float>(views));
        for (std::size_t m = 0; m < methods.size(); ++m) {
            stage.draw_with(&methods[m].lines);
            const test::LineDistance d = stage.distance();
            sums[m].missing_points += d.missing_points, sums[m].points += d.points;
            sums[m].extra_pixels += d.extra_pixels, sums[m].pixels += d.pixels;
            figures[m].hausdorff = std::max(figures[m].hausdorff, d.hausdorff());
        }
    }
    for (std::size_t m = 0; m < methods.size(); ++m) {
        figures[m].lost = double(sums[m].missing_points) / double(std::max<std::size_t>(1, sums[m].points));
        figures[m].extra = double(sums[m].extra_pixels) / double(std::max<std::size_t>(1, sums[m].pixels));
    }
}

void measure_steps(Stage& stage, int steps, std::array<Figures, methods.size()>& figures) {
    stage.turn(0.4f);
    for (int step = 0; step < steps; ++step) {
        stage.shift(1.0f / 16.0f);
        for (std::size_t m = 0; m < methods.size(); ++m) {
            stage.draw_with(&methods[m].lines);
            const test::LineDistance d = stage.distance();
            figures[m].lost_by_step.push_back(stage.exact_length() * double(d.missing_points) /
                                              double(std::max<std::size_t>(1, d.points)));
        }
    }
}

std::array<Figures, methods.size()> measure(const std::filesystem::path& model, bool quick) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    Stage stage(*context, benchmark_model(model, quick), quick ? Canvas{64, 48} : Canvas{1024, 768});
    std::array<Figures, methods.size()> figures;
    for (std::size_t m = 0; m < methods.size(); ++m) measure_cost(stage, methods[m], quick ? 2 : 15, figures[m]);
    measure_distance(stage, quick ? 2 : 8, figures);
    measure_steps(stage, quick ? 2 : 32, figures);
    return figures;
}

void write_chart(const std::filesystem::path& path, bool quick) {
    const std::array<Figures, methods.size()> figures = measure({}, quick);
    std::ofstream file(path);
    file << "panel,method,x,y,z\n";
    for (std::size_t m = 0; m < methods.size(); ++m) {
        const Figures& f = figures[m];
        // Logarithmic axes have no zero: what was not found at all stands at their rim.
        file << fmt::format("cost,{},{},{},{}\n", methods[m].name, bench::median(f.ratio) - 1.0,
                            std::max(1e-5, f.lost + f.extra), f.hausdorff);
        for (std::size_t step = 0; step < f.lost_by_step.size(); ++step)
            file << fmt::format("steps,{},{},{},0\n", methods[m].name, double(step + 1) / 16.0,
                                std::max(0.05, f.lost_by_step[step]));
    }
    if (!file) throw Error(path.string(), "the file could not be written");
}

int run(int argc, char** argv) {
    if (argc >= 3 && std::string_view(argv[1]) == "--chart") {
        write_chart(argv[2], argc == 4 && std::string_view(argv[3]) == "--quick");
        return 0;
    }
    const bench::Arguments arguments =
        bench::parse_arguments(argc, argv, "Cost and fidelity of edge lines, for bunny at 1024x768.");
    const std::array<Figures, methods.size()> figures = measure(arguments.model, arguments.quick);
    bench::Report report(arguments);
    for (std::size_t m = 0; m < methods.size(); ++m) {
        const Figures& f = figures[m];
        const std::string name = methods[m].name;
        report.add(name + ": added to a frame without lines", bench::median(f.ms), "ms");
        report.add(name + ": frame over the same without lines", bench::median(f.ratio), "ratio");
        const bool exact = m == 1;
        const auto add = [&](const std::string& what, double value, const char* unit, double limit) {
            report.add_limited(name + ": " + what, value, unit, limit);
        };
        if (name == "image") {
            report.add(name + ": lines farther than 1 px from what is drawn", 100 * f.lost, "%");
            report.add(name + ": drawn pixels farther than 1 px from a line", 100 * f.extra, "%");
            report.add(name + ": most lost in a step of 1/16 px", *std::ranges::max_element(f.lost_by_step), "px");
            continue;
        }
        if (exact) add("symmetric Hausdorff distance", f.hausdorff, "px", 1.0);
        add("lines farther than 1 px from what is drawn", 100 * f.lost, "%", exact ? 0.0 : 0.01);
        add("drawn pixels farther than 1 px from a line", 100 * f.extra, "%", exact ? 0.0 : 0.2);
        add("most lost in a step of 1/16 px", *std::ranges::max_element(f.lost_by_step), "px", exact ? 0.0 : 1.0);
    }
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_edge_lines_drawing: error: %s\n", error.what());
        return 1;
    }
}
