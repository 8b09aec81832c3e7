#include <hachure/runtime/error.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/shade_strokes_chart.h>
#include <hachure/tests/benchmarks/shade_strokes_frame.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <vector>

namespace hachure::bench {
namespace {

class ShadeChart {
public:
    ShadeChart(const std::filesystem::path& path, bool quick) : file_(path), frames_(quick ? 2 : 40) {
        file_ << "panel,series,label,x,y\n";
    }

    bool finish() { return static_cast<bool>(file_.flush()); }

    /// A share of the cells needs a tenth more shade, and less again.
    void touched(const std::string& series, const geometry::Shape& shape) {
        test::ShadeRig rig(shape);
        std::vector<float> paint(rig.mesh().cell_count(), 0.5f);
        rig.light.paint = paint;
        rig.step({});
        for (const double share : {0.125, 0.25, 0.5, 0.75, 1.0}) {
            std::vector<double> ms, cells;
            for (int i = 0; i < frames_; ++i) {
                std::fill_n(paint.begin(), static_cast<std::ptrdiff_t>(share * double(paint.size())),
                            i % 2 == 0 ? 0.55f : 0.5f);
                ++rig.light.version;
                rig.light.run();
                rig.update.changed = rig.light.swept;
                const double start = busy_ms();
                rig.update.run();
                ms.push_back(busy_ms() - start);
                cells.push_back(rig.update.stats.touched);
            }
            row("touched", series, fmt::format("{}", share), median(cells), median(ms));
        }
    }

    void bands(const geometry::Shape& shape) {
        for (const float band : {0.0025f, 0.005f, 0.01f, 0.02f, 0.04f, 0.08f, 0.16f}) {
            test::ShadeRig rig(shape, 4000, {.dead_band = band});
            const double ms = turned(rig);
            row("band", "a degree a frame", fmt::format("{}", band), ms, rig.error().mean);
        }
    }

    void cells(const geometry::Shape& shape) {
        for (const std::uint32_t count : {250u, 500u, 1000u, 2000u, 4000u, 8000u, 16000u}) {
            test::ShadeRig rig(shape, count);
            const double ms = turned(rig);
            row("cells", "a degree a frame", fmt::format("{}", count), ms, error_at_vertices(rig));
        }
    }

    void prepared(std::uint32_t around) {
        const geometry::Shape shape = geometry::irregular_torus(1.0, 0.4, around, around / 2, 0.3, 1);
        const auto triangles = static_cast<double>(shape.indices.size() / 3);
        const double start = busy_ms();
        test::ShadeRig rig(shape);
        row("prepare", "mesh", "", triangles, busy_ms() - start);
        row("prepare", "strokes from nothing", "", triangles, shade_frame(rig, 0.0).ms());
        std::vector<double> ms;
        for (int i = 1; i <= frames_ / 2; ++i) ms.push_back(shade_frame(rig, i).ms());
        row("prepare", "a frame", "", triangles, median(ms));
    }

private:
    void row(const char* panel, const std::string& series, const std::string& label, double x, double y) {
        file_ << fmt::format("{},{},{},{},{}\n", panel, series, label, x, y) << std::flush;
    }

    /// Milliseconds of a frame while the light turns.
    double turned(test::ShadeRig& rig) {
        shade_frame(rig, 0.0);
        std::vector<double> ms;
        for (int i = 1; i <= frames_; ++i) ms.push_back(shade_frame(rig, i).ms());
        return median(ms);
    }

    /// Of what is delivered from the shade that the light calls for at every vertex.
    [[nodiscard]] double error_at_vertices(const test::ShadeRig& rig) const {
        const glm::dvec3 sun = glm::normalize(glm::dvec3(sun_at(frames_)));
        const geometry::Shape& shape = rig.shape();
        const double no_shade = static_cast<double>(ShadeTone{}.no_shade);
        double sum = 0.0;
        std::size_t count = 0;
        for (std::uint32_t t = 0; t < shape.indices.size() / 3; ++t) {
            const std::uint32_t sheet = rig.mesh().sheets.triangle_of[t];
            if (sheet == geometry::SurfaceSheets::none) continue;
            const double light = std::max(0.0, glm::dot(sun, glm::dvec3(shape.normals[shape.indices[3 * t]])));
            const double wanted = std::max(0.0, no_shade - light) / no_shade;
            const std::uint32_t cell = rig.mesh().cells.cell_at(sheet, {1.0, 0.0, 0.0});
            sum += std::abs(wanted - double{rig.chains().cells[cell].delivered});
            ++count;
        }
        return sum / static_cast<double>(count);
    }

    std::ofstream file_;
    int frames_;
};

} // namespace

void write_shade_strokes_chart(const std::filesystem::path& path, bool quick) {
    ShadeChart chart(path, quick);
    const geometry::Shape small = geometry::irregular_torus(1.0, 0.4, 36, 18, 0.3, 1);
    const bool bunny_is_there = std::filesystem::exists(test::bunny_file) && !quick;
    const geometry::Shape model = bunny_is_there ? test::shape_of_file(test::bunny_file) : small;
    chart.touched("bunny", model);
    if (!quick) chart.touched("torus", geometry::irregular_torus(1.0, 0.4, 1000, 500, 0.3, 1));
    chart.bands(model);
    chart.cells(model);
    for (const std::uint32_t around : quick ? std::vector{24u} : std::vector{32u, 100u, 316u, 1000u})
        chart.prepared(around);
    if (!chart.finish()) throw Error(path.string(), "the file could not be written");
}

} // namespace hachure::bench
