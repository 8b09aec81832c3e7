#include <hachure/runtime/animation/repair_channel.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

namespace hachure::animation {
namespace {

using assets::AnimationChannel;
using assets::AnimationPath;
using assets::Interpolation;

bool all_finite(std::span<const float> values) {
    return std::ranges::all_of(values, [](float v) { return std::isfinite(v); });
}

std::optional<AnimationPath> node_path(std::string_view name) {
    if (name == "translation") return AnimationPath::translation;
    if (name == "rotation") return AnimationPath::rotation;
    if (name == "scale") return AnimationPath::scale;
    if (name == "weights") return AnimationPath::weights;
    return std::nullopt;
}

class ChannelRepair {
public:
    ChannelRepair(AnimationChannel& channel, const PoseLayout& layout, const std::string& clip,
                  assets::WarningList& warnings)
        : channel_(channel), layout_(layout), clip_(clip), warnings_(warnings) {}

    /// False when nothing is left.
    bool run() {
        if (channel_.path == AnimationPath::pointer) resolve_node_pointer();
        if (!target_fits()) return false;
        choose_keys();
        if (kept_.empty()) return warn("animation channels without keys are left out");
        rebuild();
        if (channel_.times.front() < 0.0f) warn("animation keys before time 0 lie outside of their clip");
        if (channel_.path == AnimationPath::rotation) normalise_rotations();
        return true;
    }

private:
    /// Says it of this clip and target; false, for a last word.
    bool warn(std::string_view kind) {
        std::string target = channel_.pointer;
        if (channel_.path != AnimationPath::pointer) {
            const auto node = static_cast<std::size_t>(channel_.node);
            const bool named = channel_.node >= 0 && node < layout_.nodes() && !layout_.names[node].empty();
            target = "node " + (named ? "'" + layout_.names[node] + "'" : std::to_string(channel_.node));
        }
        warnings_.add_name(kind, "clip '" + clip_ + "', " + target);
        return false;
    }

    /// "/nodes/3/rotation" says the same as a node and a path.
    void resolve_node_pointer() {
        constexpr std::string_view prefix = "/nodes/";
        const std::string_view text = channel_.pointer;
        if (!text.starts_with(prefix)) return;
        std::int32_t node = -1;
        const auto [end, error] = std::from_chars(text.data() + prefix.size(), text.data() + text.size(), node);
        if (error != std::errc{} || node < 0 || end == text.data() + text.size() || *end != '/') return;
        const std::optional<AnimationPath> path =
            node_path(text.substr(static_cast<std::size_t>(end + 1 - text.data())));
        if (!path) return;
        channel_.node = node;
        channel_.path = *path;
    }

    bool target_fits() {
        if (channel_.components <= 0) return warn("animation channels without values are left out");
        if (channel_.path == AnimationPath::pointer)
            return !channel_.pointer.empty() || warn("animation channels without a target are left out");
        const auto node = static_cast<std::size_t>(channel_.node);
        if (channel_.node < 0 || node >= layout_.nodes())
            return warn("animation channels without a target are left out");
        std::size_t components = channel_.path == AnimationPath::rotation ? 4 : 3;
        if (channel_.path == AnimationPath::weights) components = layout_.weights_of(node);
        return static_cast<std::size_t>(channel_.components) == components ||
               warn("animation channels whose values do not fit their target are left out");
    }

    [[nodiscard]] std::size_t floats_per_key() const {
        return static_cast<std::size_t>(channel_.components) *
               (channel_.interpolation == Interpolation::cubic_spline ? 3 : 1);
    }
    [[nodiscard]] std::span<const float> key(std::size_t k) const {
        return {channel_.values.data() + k * floats_per_key(), floats_per_key()};
    }

    /// The indices of the keys to keep, ascending in time.
    void choose_keys() {
        const std::size_t keys = std::min(channel_.times.size(), channel_.values.size() / floats_per_key());
        if (keys != channel_.times.size() || keys * floats_per_key() != channel_.values.size())
            warn("animation channels have a wrong number of values, and play the keys that are complete");
        for (std::size_t k = 0; k < keys; ++k)
            if (std::isfinite(channel_.times[k]) && all_finite(key(k))) kept_.push_back(k);
        if (kept_.size() != keys) warn("animation keys that are not finite are left out");

        const auto time = [this](std::size_t k) { return channel_.times[k]; };
        if (!std::ranges::is_sorted(kept_, {}, time)) {
            warn("animation keys out of order are sorted");
            std::ranges::stable_sort(kept_, {}, time);
        }
        std::size_t count = 0;
        for (const std::size_t k : kept_) {
            const bool same = count > 0 && time(kept_[count - 1]) == time(k);
            kept_[same ? count - 1 : count++] = k;
        }
        if (count != kept_.size()) warn("of several animation keys at one time the last is used");
        kept_.resize(count);
    }

    void rebuild() {
        std::vector<float> times, values;
        times.reserve(kept_.size());
        values.reserve(kept_.size() * floats_per_key());
        for (const std::size_t k : kept_) {
            times.push_back(channel_.times[k]);
            values.insert(values.end(), key(k).begin(), key(k).end());
        }
        channel_.times = std::move(times);
        channel_.values = std::move(values);
    }

    /// A spline's tangents shrink with their value, so that the curve keeps its shape.
    void normalise_rotations() {
        constexpr double rounding = 1e-6;     // within it a quaternion stays as the file has it
        constexpr double quantisation = 0.01; // that of bytes
        const bool spline = channel_.interpolation == Interpolation::cubic_spline;
        for (std::size_t k = 0; k < channel_.times.size(); ++k) {
            float* first = channel_.values.data() + k * floats_per_key();
            float* value = first + (spline ? 4 : 0);
            const double length = std::sqrt(std::inner_product(value, value + 4, value, 0.0, std::plus<>(),
                                                               [](double a, double b) { return a * b; }));
            if (std::abs(length - 1.0) > quantisation) warn("animation rotations that are not unit are normalised");
            if (length < 1e-30) {
                std::fill_n(value, 3, 0.0f);
                value[3] = 1.0f;
            } else if (std::abs(length - 1.0) > rounding) {
                for (std::size_t i = 0; i < floats_per_key(); ++i) first[i] = clamped(first[i] / length);
            }
        }
    }
    static float clamped(double value) {
        constexpr double most = std::numeric_limits<float>::max();
        return static_cast<float>(std::clamp(value, -most, most));
    }

    AnimationChannel& channel_;
    const PoseLayout& layout_;
    const std::string& clip_;
    assets::WarningList& warnings_;
    std::vector<std::size_t> kept_;
};

} // namespace

std::optional<AnimationChannel> repair_channel(AnimationChannel channel, const PoseLayout& layout,
                                               const std::string& clip, assets::WarningList& warnings) {
    if (!ChannelRepair(channel, layout, clip, warnings).run()) return std::nullopt;
    return channel;
}

} // namespace hachure::animation
