#include <hachure/runtime/animation/key_search.h>
#include <hachure/runtime/animation/timeline.h>
#include <hachure/runtime/assert.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure::animation {
namespace {

/// (v[b] - v[a]) / (t[b] - t[a])
glm::dvec4 slope(std::span<const TrackKey> keys, std::size_t a, std::size_t b) {
    return (keys[b].value - keys[a].value) / (keys[b].time - keys[a].time);
}

glm::dvec4 catmull_rom(std::span<const TrackKey> keys, std::size_t k) {
    if (keys.size() == 1) return glm::dvec4(0.0);
    return slope(keys, k == 0 ? 0 : k - 1, std::min(k + 1, keys.size() - 1));
}

/// Every quaternion on the side of the one before.
std::vector<TrackKey> short_way(std::span<const TrackKey> keys) {
    std::vector<TrackKey> result(keys.begin(), keys.end());
    for (std::size_t k = 1; k < result.size(); ++k) {
        TrackKey& key = result[k];
        if (glm::dot(result[k - 1].value, key.value) >= 0.0) continue;
        key.value = -key.value;
        if (key.in) key.in = -*key.in;
        if (key.out) key.out = -*key.out;
    }
    return result;
}

double eased(KeyCurve curve, double u) {
    switch (curve) {
    case KeyCurve::ease_in:
        return u * u;
    case KeyCurve::ease_out:
        return u * (2.0 - u);
    case KeyCurve::ease_in_out:
        return u * u * (3.0 - 2.0 * u);
    case KeyCurve::step:
    case KeyCurve::linear:
    case KeyCurve::cubic:
        break;
    }
    return u;
}

/// Between unit quaternions of one side, at an even speed.
glm::dvec4 along_circle(const glm::dvec4& a, const glm::dvec4& b, double u) {
    // By half the chord and not by the cosine, which says little about small angles.
    const double angle = 2.0 * std::atan2(glm::length(b - a), glm::length(b + a));
    const double sine = std::sin(angle);
    const glm::dvec4 q =
        sine > 1e-9 ? (a * std::sin((1.0 - u) * angle) + b * std::sin(u * angle)) / sine : a * (1.0 - u) + b * u;
    return q / glm::length(q);
}

glm::dvec4 hermite(const TrackSet& set, const KeyTrack& track, std::uint32_t key, double u, double length) {
    const glm::dvec4* value = set.values.data() + track.first + key;
    const glm::dvec4* tangent = set.tangents.data() + track.first_tangent + 2 * std::size_t{key};
    const double v = 1.0 - u;
    return value[0] * ((1.0 + 2.0 * u) * v * v) + tangent[1] * (length * u * v * v) +
           value[1] * (u * u * (3.0 - 2.0 * u)) - tangent[2] * (length * u * u * v);
}

/// `u` of the way from a key to the next one, in (0, 1).
glm::dvec4 between(const TrackSet& set, const KeyTrack& track, std::uint32_t key, double u, double length) {
    const glm::dvec4* value = set.values.data() + track.first + key;
    const KeyCurve curve = set.curves[track.first + key];
    const bool turns = track.kind == TrackKind::rotation;
    if (curve == KeyCurve::step) return value[0];
    if (curve != KeyCurve::cubic) {
        const double w = eased(curve, u);
        return turns ? along_circle(value[0], value[1], w) : value[0] * (1.0 - w) + value[1] * w;
    }
    const glm::dvec4 result = hermite(set, track, key, u, length);
    if (!turns) return result;
    const double size = glm::length(result);
    return size > 1e-12 ? result / size : value[0];
}

glm::dvec4 sample(const TrackSet& set, const KeyTrack& track, double time, std::uint32_t& cursor) {
    const std::span<const double> times = set.times_of(track);
    const std::uint32_t key = cursor = KeySearch(times, time).from(cursor);
    if (time <= times[key] || key + 1 == track.count) return set.values[track.first + key];
    const double length = times[key + 1] - times[key];
    return between(set, track, key, (time - times[key]) / length, length);
}

} // namespace

void add_track(TrackSet& set, TrackKind kind, std::span<const TrackKey> keys) {
    HACHURE_ASSERT(!keys.empty(), "a track has a key");
    std::vector<TrackKey> turned;
    if (kind == TrackKind::rotation) keys = turned = short_way(keys);
    KeyTrack track{static_cast<std::uint32_t>(set.times.size()), static_cast<std::uint32_t>(keys.size()),
                   KeyTrack::no_tangents, kind};
    if (std::ranges::find(keys, KeyCurve::cubic, &TrackKey::curve) != keys.end())
        track.first_tangent = static_cast<std::uint32_t>(set.tangents.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const TrackKey& key = keys[k];
        HACHURE_ASSERT(std::isfinite(key.time) && (k == 0 || keys[k - 1].time < key.time), "key times ascend");
        HACHURE_ASSERT(kind != TrackKind::choice || key.curve == KeyCurve::step, "choices are taken in steps");
        set.times.push_back(key.time);
        set.curves.push_back(key.curve);
        set.values.push_back(key.value);
        if (track.first_tangent == KeyTrack::no_tangents) continue;
        set.tangents.push_back(key.in.value_or(catmull_rom(keys, k)));
        set.tangents.push_back(key.out.value_or(catmull_rom(keys, k)));
    }
    set.tracks.push_back(track);
}

void SampleTracksJob::validate() const {
    HACHURE_ASSERT(set != nullptr, "tracks are there");
    HACHURE_ASSERT(std::isfinite(time), "the time is finite");
    HACHURE_ASSERT(cursors.size() == set->tracks.size() && values.size() == set->tracks.size(),
                   "a cursor and a value for every track");
}

void SampleTracksJob::run() {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = sample(*set, set->tracks[i], time, cursors[i]);
}

} // namespace hachure::animation
