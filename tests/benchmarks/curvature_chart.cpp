#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/tests/benchmarks/curvature_case.h>
#include <hachure/tests/benchmarks/curvature_chart.h>

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string>

namespace hachure::bench {
namespace {

using geometry::CurvatureMethod;

struct Series {
    const char* name;
    CurvatureMethod method;
    std::span<const std::uint32_t> rings;
};

constexpr std::uint32_t own[] = {0}, quadrics[] = {2, 3, 4, 5, 6, 8}, quartics[] = {3, 4, 5, 6, 8, 12};
constexpr Series all_series[] = {{"one ring", CurvatureMethod::one_ring, own},
                                 {"degree 2", CurvatureMethod::quadric, quadrics},
                                 {"degree 4", CurvatureMethod::quartic, quartics},
                                 {"automatic", CurvatureMethod::automatic, own}};

/// Measured by others on such a torus of 10k vertices: clean, with 1 % and with 5 % of noise.
constexpr struct {
    double us, rms[3], degrees[3];
} published[] = {{0.9, {4.0, 11.0, 55.0}, {2.6, 7.5, 43.0}},
                 {14.0, {1.5, 4.9, 23.0}, {1.2, 2.8, 14.0}},
                 {80.0, {5.0, 5.0, 5.3}, {1.3, 1.4, 1.7}},
                 {60.0, {0.07, 6.6, 32.0}, {0.05, 3.2, 19.0}}};

std::string row(double noise, const char* series, std::uint32_t rings, double us, double rms, double degrees) {
    return fmt::format("{:g},{},{},{:.4g},{:.4g},{:.4g}\n", noise, series, rings, us, rms, degrees);
}

} // namespace

void write_curvature_chart(const std::filesystem::path& path, bool quick) {
    std::string csv = "noise,series,rings,us,rms,degrees\n";
    constexpr double noises[] = {0.0, 0.01, 0.05};
    for (std::size_t n = 0; n < 3; ++n) {
        CurvatureCase mesh(test::CurvedKind::torus, noises[n], quick ? 16 : 64);
        for (const Series& series : all_series)
            for (const std::uint32_t rings : series.rings) {
                const auto [us, rms, degrees] = mesh.measure(series.method, rings, quick ? 1 : 20);
                csv += row(noises[n], series.name, rings, us, rms, degrees);
            }
        for (const auto& other : published)
            csv += row(noises[n], "published", 0, other.us, other.rms[n], other.degrees[n]);
    }
    assets::write_file_atomically(path, std::as_bytes(std::span(csv.data(), csv.size())));
}

} // namespace hachure::bench
