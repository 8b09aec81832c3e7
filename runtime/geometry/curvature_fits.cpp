#include <hachure/runtime/geometry/curvature_fits.h>
#include <hachure/runtime/parallel.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace hachure::geometry {
namespace {

using Fit = CurvatureFits::Fit;

constexpr std::size_t curvature_block = 512; // vertices that a thread takes at once
constexpr std::size_t pool_rings = 2;        // around a vertex, over which noise and bias are averaged
// Differences between two levels are bias as far as they exceed what noise explains by this factor. Once is expected;
// the mean over so few fits, which share most of their vertices, is no better known than that.
constexpr double noise_doubt = 3.0;
// Squared radians by which the error turns the normal over the patch: less is not worth a second fit.
constexpr double least_turn = 1e-7;

double tensor_square(double e, double f, double g) { return e * e + 2.0 * f * f + g * g; }

double squared_difference(const Fit& a, const Fit& b) {
    return tensor_square(double{a.e} - double{b.e}, double{a.f} - double{b.f}, double{a.g} - double{b.g});
}

/// The ratio of the radii of a level and the one before, to the fourth power, with which bias grows.
double bias_growth(std::size_t level) {
    return std::pow(static_cast<double>(CurvatureFits::level_rings[level]) / CurvatureFits::level_rings[level - 1], 4);
}

Fit stored(const SurfaceFit& fit) {
    return {
        static_cast<float>(fit.e), static_cast<float>(fit.f), static_cast<float>(fit.g), fit.quartic, fit.gain, 0.0};
}

SurfaceFit fit_vertex(const CurvedMesh& mesh, std::uint32_t vertex, const PatchExtent& extent, PatchScratch& scratch) {
    return fit_surface(mesh.positions, mesh.normals, mesh.neighbours, vertex, extent, scratch);
}

} // namespace

/// Threads take blocks of vertices as they come, each with memory of its own; who takes which changes no result.
void CurvatureFits::each_vertex(const CurvedMesh& mesh, const std::function<void(std::uint32_t, PatchScratch&)>& body) {
    const std::size_t count = mesh.positions.size(), blocks = (count + curvature_block - 1) / curvature_block;
    const std::size_t workers = std::min(blocks, static_cast<std::size_t>(thread_limit()));
    if (threads_.size() < workers) threads_.resize(workers);
    std::atomic<std::size_t> next = 0;
    parallel_for(workers, [&](std::size_t worker) {
        PatchScratch& scratch = threads_[worker];
        scratch.rings.resize(count);
        for (std::size_t block = next.fetch_add(1); block < blocks; block = next.fetch_add(1))
            for (std::size_t v = block * curvature_block; v < std::min(count, (block + 1) * curvature_block); ++v)
                if (mesh.weld[v] == v) body(static_cast<std::uint32_t>(v), scratch);
    });
}

void CurvatureFits::fit(const CurvedMesh& mesh, const PatchExtent& extent) {
    fits_[0].resize(mesh.positions.size());
    error_.resize(mesh.positions.size());
    each_vertex(mesh, [&](std::uint32_t v, PatchScratch& scratch) {
        const SurfaceFit fit = fit_vertex(mesh, v, extent, scratch);
        fits_[0][v] = stored(fit);
        error_[v] = fit.noise * fit.gain;
    });
}

void CurvatureFits::choose(const CurvedMesh& mesh, double tolerance, double flat) {
    const std::size_t count = mesh.positions.size();
    tolerance_ = tolerance;
    flat_ = flat;
    for (std::vector<double>* values : {&error_, &residual_, &noise_}) values->resize(count);
    unsure_.assign(count, 1);
    last_.assign(count, 0);
    fit_level(mesh, 0);
    pool_noise(mesh);
    for (std::size_t level = 1; level < level_rings.size(); ++level) {
        if (std::ranges::find(unsure_, 1) == unsure_.end()) break;
        fit_level(mesh, level);
        find_bias(mesh, level);
    }
    each_vertex(mesh, [&](std::uint32_t v, PatchScratch&) { blend(v); });
}

void CurvatureFits::fit_level(const CurvedMesh& mesh, std::size_t level) {
    fits_[level].resize(mesh.positions.size());
    each_vertex(mesh, [&](std::uint32_t v, PatchScratch& scratch) {
        if (!unsure_[v]) return;
        const SurfaceFit fit = fit_vertex(mesh, v, {.degree = 4, .rings = level_rings[level]}, scratch);
        fits_[level][v] = stored(fit);
        if (level == 0) residual_[v] = fit.noise;
        if (level > 0) unsure_[v] = fit.quartic;
        if (fit.quartic) last_[v] = static_cast<std::uint8_t>(level);
    });
}

void CurvatureFits::pool_noise(const CurvedMesh& mesh) {
    each_vertex(mesh, [&](std::uint32_t v, PatchScratch& scratch) {
        scratch.rings.start(v);
        scratch.rings.grow(mesh.neighbours, pool_rings);
        double sum = 0.0, count = 0.0;
        for (const std::uint32_t other : scratch.rings.vertices()) {
            if (!fits_[0][other].quartic) continue;
            sum += residual_[other];
            ++count;
        }
        noise_[v] = count > 0.0 ? sum / count : residual_[v];
        unsure_[v] = count > 0.0 && !is_good(v, 0);
    });
}

/// Two nested least-squares fits differ by the bias of the wider one, less that of the narrower, and by noise of the
/// variance that the wider one has less (Hausman 1978).
void CurvatureFits::find_bias(const CurvedMesh& mesh, std::size_t level) {
    const double growth = bias_growth(level), share = 1.0 - 1.0 / growth; // of the wider one's bias in the difference
    each_vertex(mesh, [&](std::uint32_t v, PatchScratch& scratch) {
        if (!unsure_[v]) return;
        scratch.rings.start(v);
        scratch.rings.grow(mesh.neighbours, pool_rings);
        double sum = 0.0, count = 0.0;
        for (const std::uint32_t other : scratch.rings.vertices()) {
            if (last_[other] != level) continue;
            const double by_noise = std::max(0.0, noise_error(other, level - 1) - noise_error(other, level));
            sum += squared_difference(fits_[level][other], fits_[level - 1][other]) - noise_doubt * by_noise;
            ++count;
        }
        fits_[level][v].bias = std::max(0.0, sum / count) / (share * share);
    });
    each_vertex(mesh, [&](std::uint32_t v, PatchScratch&) {
        const double next_bias =
            fits_[level][v].bias * (level + 1 < level_rings.size() ? std::pow(bias_growth(level + 1), 2) : 0.0);
        if (unsure_[v] && (is_good(v, level) || noise_error(v, level) < next_bias)) unsure_[v] = 0;
    });
}

bool CurvatureFits::is_good(std::uint32_t vertex, std::size_t level) const {
    const Fit& fit = fits_[level][vertex];
    const double error = noise_error(vertex, level), curvature = tensor_square(fit.e, fit.f, fit.g);
    return error <= tolerance_ * tolerance_ * std::max(curvature, flat_ * flat_) ||
           noise_[vertex] * std::sqrt(fit.gain) <= least_turn;
}

/// The bias of fewer rings is at least what the law of its growth makes of that of more rings.
void CurvatureFits::blend(std::uint32_t vertex) {
    if (last_[vertex] == 0) {
        error_[vertex] = noise_error(vertex, 0);
        return;
    }
    double bias = 0.0, e = 0.0, f = 0.0, g = 0.0, weights = 0.0, least = std::numeric_limits<double>::max();
    for (std::size_t level = last_[vertex] + std::size_t{1}; level-- > 0;) {
        const Fit& fit = fits_[level][vertex];
        if (!fit.quartic) continue; // at a corner of a border, where the first level is none
        bias = std::max(bias, fit.bias);
        const double error = noise_error(vertex, level) + bias, weight = 1.0 / (error * error);
        e += weight * fit.e;
        f += weight * fit.f;
        g += weight * fit.g;
        weights += weight;
        least = std::min(least, error);
        if (level > 0) bias /= std::pow(bias_growth(level), 2);
    }
    error_[vertex] = least;
    Fit& result = fits_[0][vertex];
    result.e = static_cast<float>(e / weights);
    result.f = static_cast<float>(f / weights);
    result.g = static_cast<float>(g / weights);
}

} // namespace hachure::geometry
