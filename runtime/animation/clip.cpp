#include <hachure/runtime/animation/clip.h>
#include <hachure/runtime/animation/repair_channel.h>
#include <hachure/runtime/assert.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace hachure::animation {
namespace {

using assets::AnimationChannel;

std::uint32_t narrow(std::size_t count) {
    HACHURE_ASSERT(count <= std::numeric_limits<std::uint32_t>::max(), "a clip is counted in 32 bits");
    return static_cast<std::uint32_t>(count);
}

/// Gives names that no other clip of the set has.
class ClipNames {
public:
    explicit ClipNames(assets::WarningList& warnings) : warnings_(warnings) {}

    std::string unique(const std::string& name, std::size_t index) {
        const std::string wanted = name.empty() ? "clip " + std::to_string(index) : name;
        std::string result = wanted;
        for (std::size_t& n = next_[wanted]; !taken_.insert(result).second; ++n)
            result = wanted + " " + std::to_string(n + 2);
        if (name.empty())
            warnings_.add_name("clips without a name get one", "'" + result + "'");
        else if (result != name)
            warnings_.add_name("clips whose name is taken are renamed", "'" + result + "'");
        return result;
    }

private:
    assets::WarningList& warnings_;
    std::set<std::string> taken_;
    std::map<std::string, std::size_t> next_;
};

/// Lays the repaired channels of one animation out as a clip.
class ClipBuilder {
public:
    ClipBuilder(const assets::Model& model, const PoseLayout& layout, assets::WarningList& warnings)
        : model_(model), layout_(layout), warnings_(warnings) {}

    Clip build(const assets::Animation& animation, std::string name) {
        clip_.name = std::move(name);
        repair(animation);
        keep_last_of_each_target();
        for (const AnimationChannel& channel : channels_) add_track(channel);
        place_tables();
        for (std::size_t t = 0; t < channels_.size(); ++t) fill_values(channels_[t], clip_.tracks[t]);
        collect_targets();
        for (const float time : clip_.times) clip_.duration = std::max(clip_.duration, static_cast<double>(time));
        if (channels_.empty())
            warnings_.add_name("clips move nothing", "'" + clip_.name + "'");
        else if (clip_.duration == 0.0)
            warnings_.add_name("clips last no time and show a single pose", "'" + clip_.name + "'");
        return std::move(clip_);
    }

private:
    void repair(const assets::Animation& animation) {
        for (const AnimationChannel& channel : animation.channels)
            if (std::optional<AnimationChannel> repaired = repair_channel(channel, layout_, clip_.name, warnings_))
                channels_.push_back(std::move(*repaired));
    }

    /// Tracks of one kind stand together, so that sampling takes the same branches many times in a row.
    void keep_last_of_each_target() {
        const auto target = [](const AnimationChannel& c) {
            return std::tuple(c.path, c.node, c.path == AnimationPath::pointer ? c.pointer : std::string());
        };
        std::ranges::stable_sort(channels_, {}, target);
        std::vector<AnimationChannel> last;
        for (std::size_t i = 0; i < channels_.size(); ++i) {
            if (i + 1 == channels_.size() || target(channels_[i]) != target(channels_[i + 1]))
                last.push_back(std::move(channels_[i]));
            else
                warnings_.add_name("of several animation channels with one target the last is used",
                                   "clip '" + clip_.name + "', " + name_of(channels_[i]));
        }
        channels_ = std::move(last);
        std::ranges::stable_sort(channels_, {},
                                 [](const AnimationChannel& c) { return std::tuple(c.path, c.interpolation, c.node); });
    }

    [[nodiscard]] std::string name_of(const AnimationChannel& channel) const {
        if (channel.path == AnimationPath::pointer) return channel.pointer;
        const std::string& name = layout_.names[static_cast<std::size_t>(channel.node)];
        return "node " + (name.empty() ? std::to_string(channel.node) : "'" + name + "'");
    }

    void add_track(const AnimationChannel& channel) {
        Track track;
        track.node = channel.path == AnimationPath::pointer ? -1 : channel.node;
        track.path = channel.path;
        track.interpolation = channel.interpolation;
        track.components = static_cast<std::uint32_t>(channel.components);
        track.key_times = shared_times(channel.times);
        KeyTimes& table = clip_.key_times[track.key_times];
        track.column = table.row;
        table.row = narrow(table.row + channel.values.size() / channel.times.size());
        if (channel.path == AnimationPath::weights)
            track.output = layout_.first_weight[static_cast<std::size_t>(channel.node)];
        if (channel.path == AnimationPath::pointer) {
            track.output = narrow(clip_.pointer_floats());
            clip_.pointers.push_back({channel.pointer, track.output, track.components});
        }
        clip_.tracks.push_back(track);
    }

    std::uint32_t shared_times(const std::vector<float>& times) {
        const auto [at, is_new] = known_times_.try_emplace(times, narrow(clip_.key_times.size()));
        if (is_new) {
            clip_.key_times.push_back({narrow(clip_.times.size()), narrow(times.size()), 0, 0});
            clip_.times.insert(clip_.times.end(), times.begin(), times.end());
        }
        return at->second;
    }

    void place_tables() {
        std::size_t end = 0;
        for (KeyTimes& table : clip_.key_times) {
            table.first_value = narrow(end);
            end += static_cast<std::size_t>(table.count) * table.row;
        }
        clip_.values.resize(narrow(end));
    }

    void fill_values(const AnimationChannel& channel, const Track& track) {
        const KeyTimes& table = clip_.key_times[track.key_times];
        const std::size_t width = channel.values.size() / channel.times.size();
        for (std::size_t k = 0; k < table.count; ++k)
            std::copy_n(channel.values.data() + k * width, width,
                        clip_.values.data() + table.first_value + k * table.row + track.column);
    }

    void collect_targets() {
        std::map<std::uint32_t, std::uint8_t> parts;
        for (const Track& track : clip_.tracks)
            if (track.node >= 0)
                parts[static_cast<std::uint32_t>(track.node)] |=
                    static_cast<std::uint8_t>(1u << static_cast<unsigned>(track.path));
        for (const auto& [node, bits] : parts) {
            clip_.targets.push_back({node, bits});
            if (model_.nodes[node].matrix)
                warnings_.add_name("animated nodes lose their matrix",
                                   "clip '" + clip_.name + "', node '" + layout_.names[node] + "'");
        }
    }

    const assets::Model& model_;
    const PoseLayout& layout_;
    assets::WarningList& warnings_;
    std::vector<AnimationChannel> channels_;
    std::map<std::vector<float>, std::uint32_t> known_times_;
    Clip clip_;
};

static_assert(1u << static_cast<unsigned>(AnimationPath::translation) == moves_translation &&
              1u << static_cast<unsigned>(AnimationPath::rotation) == moves_rotation &&
              1u << static_cast<unsigned>(AnimationPath::scale) == moves_scale &&
              1u << static_cast<unsigned>(AnimationPath::weights) == moves_weights);

} // namespace

ClipSet compile_clips(const assets::Model& model, std::vector<std::string>& warnings) {
    ClipSet set;
    set.layout = pose_layout(model);
    assets::WarningList found;
    ClipNames names(found);
    for (std::size_t i = 0; i < model.animations.size(); ++i) {
        const assets::Animation& animation = model.animations[i];
        set.clips.push_back(ClipBuilder(model, set.layout, found).build(animation, names.unique(animation.name, i)));
    }
    for (std::string& line : found.lines()) warnings.push_back(std::move(line));
    return set;
}

std::optional<std::uint32_t> find_clip(const ClipSet& set, std::string_view name) {
    const auto at = std::ranges::find(set.clips, name, &Clip::name);
    if (at == set.clips.end()) return std::nullopt;
    return static_cast<std::uint32_t>(at - set.clips.begin());
}

const Track* find_track(const Clip& clip, std::uint32_t node, AnimationPath path) {
    const auto at = std::ranges::find_if(clip.tracks, [&](const Track& track) {
        return track.path == path && track.node == static_cast<std::int32_t>(node);
    });
    return at == clip.tracks.end() ? nullptr : &*at;
}

} // namespace hachure::animation
