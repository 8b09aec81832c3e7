#include <hachure/runtime/app/log.h>
#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/metal/metal_frame.h>
#include <hachure/systems/metal/stripe_layout.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <span>

namespace hachure {
namespace {

constexpr std::size_t shader_knots = 512; // MAX_KNOTS of shaders/metal/ramp.glsl
static_assert(shader_knots >= 2 * Metal::max_count);

constexpr std::size_t most_ramps = 256; // of 8 KiB
constexpr double long_seconds = 2.0;    // what the user is told of

RampBuffer make_ramp_buffer(const StripeSet& set) {
    StripeRamp ramp = make_stripe_ramp(set);
    const auto count = static_cast<int>(ramp.knots.size());
    ramp.knots.resize(shader_knots, glm::vec4(0.0f)); // a uniform block has one size
    return {gpu::Buffer(std::span<const glm::vec4>(ramp.knots), "metal ramp"), count, static_cast<float>(ramp.mean)};
}

} // namespace

void MetalFrame::begin() {
    wanted_.clear();
    drawn_ = 0;
    if (ramps_.size() > most_ramps) ramps_.clear(); // those of settings that were tried and left
}

const RampBuffer& MetalFrame::ramp(const StripeSet& set) {
    const std::uint64_t key = gpu::key_of(set.seed, set.count, set.low, set.high, set.mirrored);
    const auto found = ramps_.find(key);
    return found != ramps_.end() ? found->second : ramps_.emplace(key, make_ramp_buffer(set)).first->second;
}

void MetalFrame::want_layout(std::uint64_t key, const SurfaceMesh& mesh, const Metal& metal) {
    ++drawn_;
    if (!wanted_.insert(key).second || surfaces.has_layout(key)) return;
    missing_.push_back({key, &mesh, &metal});
    if (stripe_source(mesh, metal) != metal.source && warned_.insert(mesh.name).second)
        log_warning(
            fmt::format("mesh '{}' has no texture coordinates: its stripes of metal follow its curvature", mesh.name));
}

void MetalFrame::lay_out_wanted() {
    if (missing_.empty()) return;
    const auto start = std::chrono::steady_clock::now();
    std::vector<geometry::StripeMesh> results(missing_.size());
    parallel_for(missing_.size(),
                 [&](std::size_t i) { results[i] = lay_stripes(*missing_[i].mesh, *missing_[i].metal); });
    for (std::size_t i = 0; i < missing_.size(); ++i) surfaces.add(missing_[i].key, std::move(results[i]));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (seconds > long_seconds)
        log_note(fmt::format("stripes of metal were laid on {} mesh{} in {:.1f} s", missing_.size(),
                             missing_.size() == 1 ? "" : "es", seconds));
    missing_.clear();
}

} // namespace hachure
