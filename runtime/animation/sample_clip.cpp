#include <hachure/runtime/animation/interpolate.h>
#include <hachure/runtime/animation/key_search.h>
#include <hachure/runtime/animation/sample_clip.h>
#include <hachure/runtime/assert.h>

#include <algorithm>
#include <cmath>

namespace hachure::animation {
namespace {

using Place = SampleCache::Place;

/// Between which keys a moment lies, when `key` is the last one at or before it.
Place place_at(std::span<const float> times, double time, std::uint32_t key) {
    if (time < times[key] || key + 1 == times.size()) return {key, 0.0f, 0.0};
    const double start = times[key], length = times[key + 1] - start;
    return {key, static_cast<float>((time - start) / length), length};
}

std::span<const float> key_times_of(const Clip& clip, const KeyTimes& keys) {
    return {clip.times.data() + keys.first, keys.count};
}

/// The values of one track around a moment.
struct Keys {
    const float* now; ///< the key's row and column
    const float* next;
    Place place;
    const Track& track;

    Keys(const Clip& clip, const Track& which, const Place& where) : place(where), track(which) {
        const KeyTimes& table = clip.key_times[which.key_times];
        now = clip.values.data() + table.first_value + static_cast<std::size_t>(where.key) * table.row + which.column;
        next = where.fraction == 0.0f ? now : now + table.row;
    }

    /// Component i between the keys.
    [[nodiscard]] float operator()(std::size_t i) const {
        const std::size_t n = track.components;
        switch (track.interpolation) {
        case Interpolation::linear:
            return place.fraction == 0.0f ? now[i] : lerp(now[i], next[i], place.fraction);
        case Interpolation::cubic_spline:
            return place.fraction == 0.0f ? now[n + i] : finite_float(spline(i, weights()));
        case Interpolation::step:
            break;
        }
        return now[i];
    }

    [[nodiscard]] HermiteWeights weights() const { return {place.fraction, place.key_length}; }
    [[nodiscard]] double spline(std::size_t i, const HermiteWeights& weights) const {
        const std::size_t n = track.components;
        return weights.mix(now[n + i], now[2 * n + i], next[n + i], next[i]);
    }

    [[nodiscard]] glm::vec3 vector() const { return {(*this)(0), (*this)(1), (*this)(2)}; }

    [[nodiscard]] glm::quat rotation() const {
        const auto at = [](const float* v) { return glm::quat(v[3], v[0], v[1], v[2]); };
        const bool cubic = track.interpolation == Interpolation::cubic_spline;
        const glm::quat start = at(now + (cubic ? 4 : 0));
        if (place.fraction == 0.0f || track.interpolation == Interpolation::step) return start;
        if (!cubic) return slerp_short(start, at(next), place.fraction);
        const HermiteWeights w = weights();
        const glm::dquat q(spline(3, w), spline(0, w), spline(1, w), spline(2, w));
        const double length = std::sqrt(glm::dot(q, q));
        return length > 1e-12 ? glm::quat(q / length) : start;
    }

    void copy_to(float* out) const {
        for (std::size_t i = 0; i < track.components; ++i) out[i] = (*this)(i);
    }
};

void write_joint(const Keys& keys, JointPose& joint) {
    switch (keys.track.path) {
    case AnimationPath::translation:
        joint.translation = keys.vector();
        break;
    case AnimationPath::rotation:
        joint.rotation = keys.rotation();
        break;
    case AnimationPath::scale:
        joint.scale = keys.vector();
        break;
    case AnimationPath::weights:
    case AnimationPath::pointer:
        break;
    }
}

} // namespace

void SampleCache::reserve(const Clip& clip) { places.reserve(clip.key_times.size()); }

void SampleClipJob::validate() const {
    HACHURE_ASSERT(clip != nullptr && cache != nullptr, "a clip and a cache are there");
    HACHURE_ASSERT(std::isfinite(time), "the time is finite");
    HACHURE_ASSERT(clip->targets.empty() || clip->targets.back().node < pose.joints.size(), "a pose for every node");
    for (const Track& track : clip->tracks)
        HACHURE_ASSERT(track.path != AnimationPath::weights || track.output + track.components <= pose.weights.size(),
                       "room for every morph weight");
    HACHURE_ASSERT(pointer_values.empty() || pointer_values.size() == clip->pointer_floats(),
                   "room for the values of all pointers, or for none");
    HACHURE_ASSERT(written.empty() || written.size() == pose.joints.size(), "one mark per node, or none");
}

void SampleClipJob::run() {
    std::vector<Place>& places = cache->places;
    places.resize(clip->key_times.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::span<const float> times = key_times_of(*clip, clip->key_times[i]);
        KeySearch search(times, time);
        places[i] = place_at(times, time, search.from(places[i].key));
        cache->keys_looked_at += search.looked_at;
    }
    for (const Track& track : clip->tracks) {
        const Keys keys(*clip, track, places[track.key_times]);
        if (track.path == AnimationPath::weights)
            keys.copy_to(pose.weights.data() + track.output);
        else if (track.path != AnimationPath::pointer)
            write_joint(keys, pose.joints[static_cast<std::size_t>(track.node)]);
        else if (!pointer_values.empty())
            keys.copy_to(pointer_values.data() + track.output);
    }
    if (written.empty()) return;
    for (const ClipTarget& target : clip->targets) written[target.node] |= target.parts;
}

void sample_node(const Clip& clip, std::uint32_t node, double time, JointPose& pose) {
    HACHURE_ASSERT(std::isfinite(time), "the time is finite");
    for (const AnimationPath path : {AnimationPath::translation, AnimationPath::rotation, AnimationPath::scale}) {
        const Track* track = find_track(clip, node, path);
        if (track == nullptr) continue;
        const std::span<const float> times = clip.times_of(*track);
        write_joint(Keys(clip, *track, place_at(times, time, KeySearch(times, time).from(0))), pose);
    }
}

} // namespace hachure::animation
