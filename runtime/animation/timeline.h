#pragma once

#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hachure::animation {

/// How a track gets from a key to the next one.
enum class KeyCurve : std::uint8_t {
    step,        ///< stays until the next key
    linear,      ///< at an even speed; rotations along the great circle
    cubic,       ///< a cubic Hermite spline through both keys with their tangents
    ease_in,     ///< as linear, but from rest: u^2
    ease_out,    ///< as linear, but to rest: u (2 - u)
    ease_in_out, ///< as linear, but from rest to rest: u^2 (3 - 2u)
};

/// What the values of a track are.
enum class TrackKind : std::uint8_t {
    numbers,  ///< 1 to 4 of them
    rotation, ///< a unit quaternion x, y, z, w; the short way round is taken from key to key
    choice,   ///< x is a whole number that whoever made the track knows the meaning of; steps alone
};

/// A key as it is given to `add_track`.
struct TrackKey {
    double time = 0.0; ///< seconds, finite
    glm::dvec4 value{0.0};
    KeyCurve curve = KeyCurve::linear;     ///< from here to the next key
    std::optional<glm::dvec4> in{}, out{}; ///< tangents, per second; those of Catmull and Rom where they are absent
};

/// The keys of one quantity, in a TrackSet.
struct KeyTrack {
    std::uint32_t first = 0; ///< into TrackSet::times, curves and values
    std::uint32_t count = 0; ///< at least 1; times strictly ascending
    std::uint32_t first_tangent = no_tangents;
    TrackKind kind = TrackKind::numbers;

    static constexpr std::uint32_t no_tangents = 0xffffffff; ///< no curve is cubic
};

/// Tracks with their keys, in few arrays. Plain data.
struct TrackSet {
    std::vector<KeyTrack> tracks;
    std::vector<double> times; ///< seconds
    std::vector<KeyCurve> curves;
    std::vector<glm::dvec4> values;
    std::vector<glm::dvec4> tangents; ///< per key of a track that has them: in, then out

    [[nodiscard]] std::span<const double> times_of(const KeyTrack& track) const {
        return {times.data() + track.first, track.count};
    }
};

/// Appends a track. Keys (at least one) have finite numbers and strictly ascending times. Tangents that are not given
/// go from the key before to the key after, (v[k+1] - v[k-1]) / (t[k+1] - t[k-1]), and at the ends along the one line
/// that is there. Quaternions and their tangents are negated where that makes the way shorter.
void add_track(TrackSet& set, TrackKind kind, std::span<const TrackKey> keys);

/// All tracks of a set at a moment. Before the first key of a track its value holds, after the last the last one's. The
/// cost per track does not depend on how many keys there are while time moves on; a jump costs the logarithm of its
/// length. The result depends on the time alone, in every bit. Allocates nothing.
struct SampleTracksJob {
    const TrackSet* set = nullptr;
    double time = 0.0;                ///< seconds, finite
    std::span<std::uint32_t> cursors; ///< in and out, per track: where the last run ended; any number at first
    std::span<glm::dvec4> values;     ///< out, per track: numbers that the track has not got are 0

    /// Asserts that everything is there and sizes agree.
    void validate() const;
    void run();
};

} // namespace hachure::animation
