#pragma once

#include <hachure/runtime/assets/model.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// Sampling as glTF 2.0, appendix C, writes it down, in double precision, straight from what a file says. Nothing here
/// is shared with the code under test.
namespace hachure::gltf_sampling {

using Value = std::vector<double>;

inline void normalise(Value& q) {
    double sum = 0.0;
    for (const double x : q) sum += x * x;
    for (double& x : q) x /= std::sqrt(sum);
}

/// One part of one key: 0 the in-tangent, 1 the value, 2 the out-tangent; only the value without cubic splines.
inline Value part(const assets::AnimationChannel& channel, std::size_t key, std::size_t which) {
    const bool cubic = channel.interpolation == assets::Interpolation::cubic_spline;
    const auto n = static_cast<std::size_t>(channel.components);
    const std::size_t first = cubic ? (3 * key + which) * n : key * n;
    Value value(n);
    for (std::size_t i = 0; i < n; ++i) value[i] = channel.values[first + i];
    return value;
}

inline Value key_value(const assets::AnimationChannel& channel, std::size_t key) {
    Value value = part(channel, key, 1);
    if (channel.path == assets::AnimationPath::rotation) normalise(value);
    return value;
}

/// C.4: v_t = sin(a (1 - t)) / sin(a) v_k + s sin(a t) / sin(a) v_k+1, a = arccos |d|, s = d / |d|.
inline Value slerp(const Value& from, const Value& to, double t) {
    double d = 0.0;
    for (std::size_t i = 0; i < 4; ++i) d += from[i] * to[i];
    const double a = std::acos(std::min(std::abs(d), 1.0)), s = d < 0.0 ? -1.0 : 1.0;
    const double w0 = a < 1e-7 ? 1.0 - t : std::sin(a * (1.0 - t)) / std::sin(a);
    const double w1 = a < 1e-7 ? t : std::sin(a * t) / std::sin(a);
    Value result(4);
    for (std::size_t i = 0; i < 4; ++i) result[i] = w0 * from[i] + s * w1 * to[i];
    return result;
}

/// C.5: v_t = (2t^3 - 3t^2 + 1) v_k + td (t^3 - 2t^2 + t) b_k + (-2t^3 + 3t^2) v_k+1 + td (t^3 - t^2) a_k+1.
inline Value cubic(const assets::AnimationChannel& channel, std::size_t key, double t, double td) {
    const Value v0 = part(channel, key, 1), b0 = part(channel, key, 2);
    const Value a1 = part(channel, key + 1, 0), v1 = part(channel, key + 1, 1);
    const double t2 = t * t, t3 = t2 * t;
    Value result(v0.size());
    for (std::size_t i = 0; i < v0.size(); ++i)
        result[i] = (2 * t3 - 3 * t2 + 1) * v0[i] + td * (t3 - 2 * t2 + t) * b0[i] + (-2 * t3 + 3 * t2) * v1[i] +
                    td * (t3 - t2) * a1[i];
    if (channel.path == assets::AnimationPath::rotation) normalise(result);
    return result;
}

/// A channel whose keys ascend, at a time in seconds.
inline Value sample(const assets::AnimationChannel& channel, double time) {
    const auto after = std::upper_bound(channel.times.begin(), channel.times.end(), time);
    if (after == channel.times.begin()) return key_value(channel, 0);
    const auto key = static_cast<std::size_t>(after - channel.times.begin()) - 1;
    if (after == channel.times.end() || channel.interpolation == assets::Interpolation::step)
        return key_value(channel, key);
    const double start = channel.times[key], td = static_cast<double>(channel.times[key + 1]) - start;
    const double t = (time - start) / td;
    if (channel.interpolation == assets::Interpolation::cubic_spline) return cubic(channel, key, t, td);
    const Value from = key_value(channel, key), to = key_value(channel, key + 1);
    if (channel.path == assets::AnimationPath::rotation) return slerp(from, to, t);
    Value result(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) result[i] = (1.0 - t) * from[i] + t * to[i];
    return result;
}

/// The largest number in the channel's values: what errors are relative to.
inline double magnitude(const assets::AnimationChannel& channel) {
    double most = 0.0;
    for (const float v : channel.values) most = std::max(most, std::abs(static_cast<double>(v)));
    return most;
}

} // namespace hachure::gltf_sampling
