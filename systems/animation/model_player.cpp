#include <hachure/systems/animation/model_player.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

animation::LoopMode loop_mode(Repeat repeat) {
    switch (repeat) {
    case Repeat::once:
        return animation::LoopMode::once;
    case Repeat::ping_pong:
        return animation::LoopMode::ping_pong;
    case Repeat::loop:
        break;
    }
    return animation::LoopMode::loop;
}

/// Playing time counts clip seconds, so that a change of speed goes on from where the clip is.
animation::Playback playback(const ModelClips& clips, std::int32_t clip, float speed, Repeat repeat, float offset) {
    const double duration = clip < 0 ? 0.0 : clips.set.clips[static_cast<std::size_t>(clip)].duration;
    return {.duration = duration, .speed = speed < 0.0f ? -1.0 : 1.0, .mode = loop_mode(repeat), .offset = offset};
}

bool moves_on(const ClipSource& source) {
    return source.clip >= 0 && source.playback.duration > 0.0 && !animation::finished(source.playback, source.time);
}

} // namespace

bool ModelPlayer::advance(const PlayRequest& request, const ModelClips& clips, double delta,
                          std::vector<std::string>& warnings) {
    set_root_motion(request.root_motion, clips, warnings);
    bool moved = request.states ? advance_states(*request.states, request.animation, clips, delta)
                                : advance_animation(*request.animation, clips, delta, warnings);
    // What stands still has passed nothing, however often layers over it are shown anew.
    if (!moved)
        for (ClipSource& source : mix.sources) source.previous = source.time;
    const bool paused = request.animation && !request.animation->playing;
    const AnimationLayers none;
    moved |= advance_layers(request.layers ? *request.layers : none, clips, paused ? 0.0 : delta, warnings);
    started_ = true;
    return moved;
}

std::int32_t ModelPlayer::find(const ModelClips& clips, std::string_view name,
                               std::vector<std::string>& warnings) const {
    if (name.empty()) return -1;
    if (const auto found = animation::find_clip(clips.set, name)) return static_cast<std::int32_t>(*found);
    warnings.push_back("there is no clip '" + std::string(name) + "'");
    return -1;
}

void ModelPlayer::begin_fade(const Animation& wanted) {
    fading_ = current_;
    fade_length_ = wanted.fade;
    fade_time_ = 0.0;
}

bool ModelPlayer::advance_animation(const Animation& wanted, const ModelClips& clips, double delta,
                                    std::vector<std::string>& warnings) {
    const bool changed = !started_ || !(wanted == animation);
    const bool other_clip = !started_ || wanted.clip != animation.clip;
    const bool runs = wanted.playing && wanted.speed != 0.0f;
    if (!changed && !(runs && (moves_on(current_) || fade_length_ > 0.0))) return false;
    const double old_time = animation.time;
    animation = wanted;
    if (other_clip) {
        // Nobody said where in the new clip to begin.
        if (started_ && wanted.time == old_time) animation.time = 0.0;
        if (started_) begin_fade(wanted);
        current_ = {.clip = find(clips, wanted.clip, warnings)};
    }
    current_.playback = playback(clips, current_.clip, wanted.speed, wanted.repeat, wanted.offset);
    const double step = wanted.playing ? delta * std::abs(double{wanted.speed}) : 0.0;
    current_.previous = other_clip ? animation::not_started : current_.time;
    current_.time = animation.time += step;
    fading_.previous = fading_.time;
    fading_.time += step;
    if (wanted.playing) fade_time_ += delta;
    if (fade_time_ >= fade_length_) fade_length_ = 0.0;
    mix.sources.assign(1, current_);
    if (fade_length_ > 0.0) {
        mix.sources[0].weight = static_cast<float>(fade_time_ / fade_length_);
        mix.sources.push_back(fading_);
        mix.sources[1].weight = 1.0f - mix.sources[0].weight;
    }
    return true;
}

bool ModelPlayer::advance_states(const AnimationStates& wanted, const Animation* pace, const ModelClips& clips,
                                 double delta) {
    const double step = !pace ? delta : pace->playing ? delta * std::max(0.0, double{pace->speed}) : 0.0;
    if (started_ && step == 0.0 && wanted.parameters == states.parameters && wanted.state == states.state) return false;
    if (!started_ && !animation::check_state_machine(wanted.machine).empty()) return false;
    states = wanted;
    if (states.parameters.size() != states.machine.parameters.size())
        states.parameters = animation::initial_parameters(states.machine);
    animation::step_state_machine(states.machine, states.parameters, step, states.state);
    mix.sources.clear();
    for (const animation::ActiveState& active : states.state.states()) {
        const animation::State& state = states.machine.states[active.state];
        const bool known = state.clip >= 0 && static_cast<std::size_t>(state.clip) < clips.set.clips.size();
        mix.sources.push_back(
            {known ? state.clip : -1, state.playback, active.previous_time, active.time, active.weight});
    }
    std::ranges::reverse(mix.sources); // the state that it is in comes first
    return true;
}

bool ModelPlayer::advance_layers(const AnimationLayers& wanted, const ModelClips& clips, double delta,
                                 std::vector<std::string>& warnings) {
    const bool changed = !(wanted == layers);
    const auto plays = [](const LayerSource& layer) { return layer.source.weight > 0.0f && moves_on(layer.source); };
    if (!changed && (delta == 0.0 || std::ranges::none_of(mix.layers, plays))) return false;
    const bool same = wanted.layers.size() == layers.layers.size() &&
                      std::ranges::equal(wanted.layers, layers.layers, [](const auto& a, const auto& b) {
                          return a.clip == b.clip && a.mask == b.mask;
                      });
    if (!same) mix.layers.clear();
    mix.layers.resize(wanted.layers.size());
    layers = wanted;
    for (std::size_t i = 0; i < layers.layers.size(); ++i) {
        AnimationLayer& layer = layers.layers[i];
        LayerSource& out = mix.layers[i];
        if (!same) {
            out.source.clip = find(clips, layer.clip, warnings);
            if (!layer.mask.empty()) {
                auto mask = animation::make_mask(clips.set.layout, layer.mask);
                if (!mask) warnings.push_back("there is no node '" + layer.mask + "' for a mask");
                out.mask = mask ? std::move(*mask) : std::vector<float>(clips.set.layout.nodes(), 0.0f);
            }
        }
        out.additive = layer.additive;
        out.source.playback = playback(clips, out.source.clip, layer.speed, layer.repeat, layer.offset);
        out.source.weight = std::clamp(layer.weight, 0.0f, 1.0f);
        out.source.previous = out.source.time;
        out.source.time = layer.time += delta * std::abs(double{layer.speed});
    }
    return true;
}

void ModelPlayer::set_root_motion(const RootMotion* wanted, const ModelClips& clips,
                                  std::vector<std::string>& warnings) {
    if (has_root_motion_ == (wanted != nullptr) && (!wanted || *wanted == root_motion_)) return;
    has_root_motion_ = wanted != nullptr;
    mix.root_motion.reset();
    if (!wanted) return;
    root_motion_ = *wanted;
    const auto node = animation::find_node(clips.set.layout, wanted->joint);
    if (!node) {
        warnings.push_back("there is no node '" + wanted->joint + "' for root motion");
        return;
    }
    mix.root_motion = animation::RootMotionOptions{
        .node = *node, .horizontal = wanted->horizontal, .vertical = wanted->vertical, .rotation = wanted->rotation};
}

void ModelPlayer::collect_events(Entity model, const ModelClips& clips, const AnimationEvents& events,
                                 std::vector<ClipEvent>& sent) {
    for (const ClipSource& source : mix.sources) {
        if (source.clip < 0) continue;
        const std::string& name = clips.set.clips[static_cast<std::size_t>(source.clip)].name;
        const auto found = events.by_clip.find(name);
        if (found == events.by_clip.end()) continue;
        animation::PassedEventsJob{.events = found->second,
                                   .playback = source.playback,
                                   .from = source.previous,
                                   .to = source.time,
                                   .passed = &passed_}
            .run();
        for (const animation::PassedEvent& event : passed_)
            sent.push_back({model, name, found->second[event.event].name, found->second[event.event].time});
    }
}

} // namespace hachure
