#include <hachure/runtime/parallel.h>
#include <hachure/tests/benchmarks/curvature_case.h>

#include <algorithm>
#include <ctime>
#include <limits>

namespace hachure::bench {

CurvatureCase::CurvatureCase(test::CurvedKind kind, double noise, std::uint32_t cells)
    : mesh_(kind, {.noise = noise, .cells = cells}), curvatures_(mesh_.positions.size()),
      directions_(mesh_.positions.size()) {
    neighbours_.build(mesh_.indices, mesh_.weld);
}

CurvatureCase::Figures CurvatureCase::measure(geometry::CurvatureMethod method, std::uint32_t rings, int rounds) {
    const int threads = thread_limit();
    set_thread_limit(1);
    geometry::CurvatureJob job{.positions = mesh_.positions,
                               .normals = mesh_.normals,
                               .indices = mesh_.indices,
                               .weld = mesh_.weld,
                               .curvatures = curvatures_,
                               .directions = directions_,
                               .method = method,
                               .rings = rings,
                               .neighbours = &neighbours_};
    job.run();
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i < rounds; ++i) {
        const std::clock_t start = std::clock(); // of this thread alone: others on the machine do not count
        job.run();
        best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    set_thread_limit(threads);
    const test::CurvedCase::Errors errors = mesh_.errors(curvatures_, directions_);
    return {1e6 * best / static_cast<double>(vertices()), 100.0 * errors.rms, errors.degrees95};
}

} // namespace hachure::bench
