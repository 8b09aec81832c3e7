#include <hachure/editor/open_input.h>
#include <hachure/editor/play/allocation_counter.h>
#include <hachure/editor/play/played_scene.h>
#include <hachure/editor/playback_clock.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/app/input.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/scene/scene_seed.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/scene/scene_file.h>

namespace hachure::play {
namespace {

/// The one place that says how a test's input is opened.
void open_scene(App& app, const PlayDocument& play) {
    const bool preset = assets::lower_extension(play.style) == ".json";
    const std::string style = preset ? (play.folder / play.style).string() : play.style;
    // A model plays its clip, a scene what it says itself.
    const bool is_scene = is_scene_name(play.scene) && play.clip.empty();
    open_input(app, play.scene, play.size, {style, is_scene ? std::nullopt : std::optional<std::string>(play.clip)});
}

void assign(App& app, std::span<const std::string> sets) {
    apply_assignments(app.world(), parse_assignments(app.types(), sets));
}

} // namespace

PlayedScene::PlayedScene(gpu::Context& context, const PlayDocument& play, std::span<const std::string> more_sets,
                         bool count)
    : play_(&play), renderer_(app_, context) {
    if (count) count_allocations(app_);
    register_capabilities(app_);
    app_.world().set_resource(Input{});
    app_.world().set_resource(SceneSeed{play.seed});
    open_scene(app_, play);
    assign(app_, play.sets);
    assign(app_, more_sets);
}

void PlayedScene::step(bool draw) {
    const auto events = play_->input.find(next_);
    step(draw, events == play_->input.end() ? std::span<const InputEvent>() : events->second);
}

void PlayedScene::step(bool draw, std::span<const InputEvent> events) {
    app_.world().resource_mutable<Input>().take(events);
    const double delta = seek(app_, play_->fps.time_of(next_++));
    draw ? renderer_.render_frame(delta) : renderer_.skip_frame(delta);
}

} // namespace hachure::play
