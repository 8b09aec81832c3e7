#pragma once

#include <hachure/runtime/animation/pose.h>
#include <hachure/runtime/assets/model.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::animation {

using assets::AnimationPath;
using assets::Interpolation;

/// Key times that one or more tracks of a clip share, and the table of those tracks' values: one row per key, so that a
/// moment of the clip is two neighbouring rows, whatever the number of tracks.
struct KeyTimes {
    std::uint32_t first = 0;       ///< into Clip::times
    std::uint32_t count = 0;       ///< at least 1; strictly ascending
    std::uint32_t first_value = 0; ///< of row 0, into Clip::values
    std::uint32_t row = 0;         ///< floats per row
};

/// How one quantity moves. Its value at key k stands at `first_value + k * row + column`; a cubic spline has there its
/// in-tangent, its value and its out-tangent, `components` floats each.
struct Track {
    std::int32_t node = -1; ///< of the file; -1 for a pointer
    AnimationPath path = AnimationPath::translation;
    Interpolation interpolation = Interpolation::linear;
    std::uint32_t components = 0; ///< floats of a value: 3, 4 (a unit quaternion x, y, z, w), or a number of weights
    std::uint32_t key_times = 0;  ///< into Clip::key_times
    std::uint32_t column = 0;     ///< in a row of the table
    /// Where the result goes: for weights, its first float in the pose's weights; for a pointer, in the pointer values.
    std::uint32_t output = 0;
};

/// A quantity outside of the poses, named by KHR_animation_pointer's JSON pointer. The clip only knows its floats:
/// whoever resolves the pointer knows what they mean.
struct PointerChannel {
    std::string pointer;
    std::uint32_t first = 0; ///< into the values that SampleClipJob writes
    std::uint32_t components = 0;
};

/// Parts of a node that a clip moves, as bits.
enum : std::uint8_t {
    moves_translation = 1,
    moves_rotation = 2,
    moves_scale = 4,
    moves_weights = 8,
};

/// A node that a clip moves, and which parts of it.
struct ClipTarget {
    std::uint32_t node = 0;
    std::uint8_t parts = 0; ///< moves_translation | ...
};

/// An animation, ready for sampling: every track has a key at least, all numbers are finite, quaternions are unit, no
/// two tracks write the same thing.
struct Clip {
    std::string name;      ///< unique in its ClipSet, never empty
    double duration = 0.0; ///< seconds: its last key; 0 for a clip that is a single pose
    std::vector<KeyTimes> key_times;
    std::vector<Track> tracks;            ///< by path, interpolation and node
    std::vector<float> times;             ///< seconds
    std::vector<float> values;            ///< see KeyTimes and Track
    std::vector<PointerChannel> pointers; ///< one per track with a pointer
    std::vector<ClipTarget> targets;      ///< the nodes it moves, ascending

    /// Floats that its pointers need in all.
    [[nodiscard]] std::size_t pointer_floats() const {
        return pointers.empty() ? 0 : pointers.back().first + pointers.back().components;
    }
    [[nodiscard]] std::span<const float> times_of(const Track& track) const {
        return {times.data() + key_times[track.key_times].first, key_times[track.key_times].count};
    }
    /// The floats of key k: `components` of them, or three times as many for a cubic spline.
    [[nodiscard]] std::span<const float> values_of(const Track& track, std::size_t k) const {
        const KeyTimes& table = key_times[track.key_times];
        const std::size_t parts = track.interpolation == Interpolation::cubic_spline ? 3 : 1;
        return {values.data() + table.first_value + k * table.row + track.column, parts * track.components};
    }
};

/// The clips of a model. Their poses have its layout.
struct ClipSet {
    PoseLayout layout;
    std::vector<Clip> clips; ///< one per animation of the model, in its order
};

/// Compiles a model's animations. Whatever the channels hold, the result is a valid ClipSet; what had to be repaired is
/// said in `warnings`, one line per kind that names the first clips and nodes:
/// - Keys out of order are sorted by time; of several keys at one time the last in the file wins.
/// - Keys before time 0 are kept: playing starts between them. Keys and values that are not finite are left out.
/// - Quaternions that are not unit are normalised (silently while the error is that of quantisation), zero becomes the
///   identity.
/// - Where there are more or fewer values than times, the keys that have both are used.
/// - A channel without keys, without a target, or whose number of components does not fit its target is left out.
/// - Of several channels with one target the last wins.
/// - A clip that lasts no time shows its one pose.
/// - Clips without a name get "clip 3" (counted from 0); a name that is taken gets " 2", " 3", ... appended.
/// Pointers to translation, rotation, scale and weights of nodes become channels of those nodes.
[[nodiscard]] ClipSet compile_clips(const assets::Model& model, std::vector<std::string>& warnings);

/// The clip of this name, or none.
[[nodiscard]] std::optional<std::uint32_t> find_clip(const ClipSet& set, std::string_view name);

/// The track that moves this part of a node, or null.
[[nodiscard]] const Track* find_track(const Clip& clip, std::uint32_t node, AnimationPath path);

} // namespace hachure::animation
