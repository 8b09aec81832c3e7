#include <hachure/components/name.h>
#include <hachure/components/picture.h>
#include <hachure/components/scene.h>
#include <hachure/editor/load_model.h>
#include <hachure/editor/open_input.h>
#include <hachure/runtime/app/log.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/numbered_files.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/scene/load_scene.h>
#include <hachure/systems/scene/scene_spawner.h>
#include <hachure/systems/styles/style.h>

#include <utility>
#include <vector>

namespace hachure {
namespace {

constexpr const char* fallback_style = "gooch";
const std::string picture_style = "lines";

/// The style that is asked for, else that of the file, else the fallback; with its name or path.
std::pair<std::string, Style> style_for(const App& app, const std::filesystem::path& input, const std::string& asked,
                                        const std::string& own) {
    if (!asked.empty()) return {asked, find_style(app.types(), asked)};
    try {
        if (!own.empty()) return {own, find_style(app.types(), own)};
    } catch (const Error& error) {
        log_warning(input.string() + ": the style that it asks for: " + error.what());
    }
    return {fallback_style, find_style(app.types(), fallback_style)};
}

void open_model(App& app, const std::filesystem::path& input, Canvas canvas, const OpenOptions& options) {
    if (!options.style.empty()) static_cast<void>(find_style(app.types(), options.style)); // faults before long work
    const SpawnedModel spawned = load_model(app, assets::read_model(input), input, canvas, options.clip);
    const auto [name, style] = style_for(app, input, options.style, spawned.style);
    apply_style(app.world(), app.types(), style);
    app.world().set_resource(SceneDocument{.style = name, .applied_style = name});
    set_scene_spawner(app, input, style);
}

void open_scene(App& app, const std::filesystem::path& input, Canvas canvas, const OpenOptions& options) {
    if (options.clip && !options.clip->empty())
        throw Error(input.string(), "is a scene, which says itself what its models play: --clip is for models");
    World& world = app.world();
    world.set_resource(canvas);
    LoadedScene scene = load_scene(app, input, {options.style, fallback_style});
    for (const std::string& warning : scene.warnings) log_warning(warning);
    check_drawable(input, scene.points);
    if (!scene.has_camera) {
        // Of an empty scene a camera sees the metre around the origin, where things may yet appear.
        if (scene.points.empty()) scene.points = {glm::vec3(-0.5f), glm::vec3(0.5f)};
        const Entity camera = spawn_framing_camera(world, scene.points, canvas);
        apply_style(world, find_style(app.types(), world.resource<SceneDocument>().applied_style), camera);
        world.add(camera, Unsaved{});
    }
    if (!scene.has_light) {
        const Entity light = spawn_default_light(world);
        apply_style(world, find_style(app.types(), world.resource<SceneDocument>().applied_style), light);
        world.add(light, Unsaved{});
    }
}

/// "shot" of "shot.####.exr".
std::string picture_name(const std::filesystem::path& input) {
    const std::string stem = input.stem().string();
    if (!assets::is_numbered_name(input)) return stem;
    const std::size_t end = stem.substr(0, stem.find('#')).find_last_not_of("._- ");
    return end == stem.npos ? stem : stem.substr(0, end + 1);
}

/// An image, a video or numbered images are one entity, with the name of the file.
void open_picture(App& app, const std::filesystem::path& input, Canvas canvas, const OpenOptions& options) {
    if (options.clip && !options.clip->empty())
        throw Error(input.string(), "is a picture, which has no clips: --clip is for models");
    const std::string name = options.style.empty() ? picture_style : options.style;
    const Style style = find_style(app.types(), name);
    if (style.picture.empty())
        throw Error(input.string(), "has no surfaces, and style '" + name + "' says nothing of pictures: " +
                                        picture_style + " does, or a preset with a \"picture\" section");
    static_cast<void>(picture_size(input)); // a file without a header that can be read ends here
    World& world = app.world();
    world.set_resource(canvas);
    world.create_with(Name{picture_name(input)}, Transform{}, Picture{.file = input.string()});
    world.create_with(Name{"camera"}, Transform{}, Camera{}, Unsaved{});
    apply_style(world, app.types(), style);
    world.set_resource(SceneDocument{.style = name, .applied_style = name});
    set_scene_spawner(app, input, style);
}

} // namespace

bool is_picture_name(const std::filesystem::path& input) {
    const assets::InputKind kind = assets::input_kind(input);
    return kind == assets::InputKind::image || kind == assets::InputKind::video;
}

Canvas picture_size(const std::filesystem::path& input) {
    if (assets::is_video_name(input)) {
        const assets::VideoFile video(input);
        return {video.width(), video.height()};
    }
    const bool numbered = assets::is_numbered_name(input);
    const assets::ImageSize size = assets::read_upright_size(numbered ? assets::NumberedFiles(input).file(0) : input);
    return {size.width, size.height};
}

void open_input(App& app, const std::filesystem::path& input, Canvas canvas, const OpenOptions& options) {
    if (is_scene_name(input))
        open_scene(app, input, canvas, options);
    else if (is_picture_name(input))
        open_picture(app, input, canvas, options);
    else
        open_model(app, input, canvas, options);
}

} // namespace hachure
