#include <hachure/components/scene.h>
#include <hachure/editor/convert_command.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/app/log.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/gltf_write.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/convert/model_to_scene.h>
#include <hachure/systems/convert/read_source.h>
#include <hachure/systems/convert/world_to_model.h>
#include <hachure/systems/scene/load_scene.h>
#include <hachure/systems/scene/scene_file.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace hachure {
namespace {

constexpr const char* usual_style = "gooch"; // of what names none, when it is drawn

enum class Form { scene, gltf, other };

Form form_of(const std::filesystem::path& file) {
    if (is_scene_name(file)) return Form::scene;
    const std::string extension = assets::lower_extension(file);
    return extension == ".glb" || extension == ".gltf" ? Form::gltf : Form::other;
}

assets::Model model_of_scene(const ConvertOptions& options, std::vector<std::string>& warnings) {
    App app;
    register_capabilities(app);
    const LoadedScene scene = load_scene(app, options.input, {"", usual_style});
    warnings = scene.warnings;
    const Style style = find_style(app.types(), app.world().resource<SceneDocument>().applied_style);
    return world_to_model(app, {scene.roots, &style, options.input, options.output}, warnings);
}

} // namespace

void add_convert_command(CLI::App& app, ConvertOptions& options) {
    CLI::App* command =
        app.add_subcommand("convert", "Make a glTF file of a scene or a model, or a scene file of a model");
    command->add_option("INPUT", options.input, "a scene (.scene.json), glTF, GLB, OBJ, PLY, OFF or STL file")
        ->required();
    command
        ->add_option("-o,--output", options.output, "FILE.glb, FILE.gltf (one file with all in it) or FILE.scene.json")
        ->required();
    command->footer("Examples: hachure convert garden.scene.json -o garden.glb\n"
                    "          hachure convert fox.glb -o fox.scene.json\n"
                    "          hachure convert bunny.obj -o bunny.glb");
}

int run_convert(const ConvertOptions& options) {
    const Form from = form_of(options.input), to = form_of(options.output);
    if (to == Form::other)
        throw UsageError("convert: '" + options.output.string() + "' is none of .glb, .gltf and .scene.json");
    if (from == Form::scene && to == Form::scene) throw UsageError("convert: both files are scenes");
    std::vector<std::string> warnings;
    if (to == Form::scene) {
        App app;
        register_capabilities(app);
        const std::string text = model_to_scene(app, options.input, options.output, warnings);
        assets::write_file_atomically(options.output, std::as_bytes(std::span(text)));
    } else if (from == Form::scene) {
        assets::write_gltf(model_of_scene(options, warnings), options.output);
    } else {
        const assets::Model model = read_source(options.input);
        warnings = model.warnings;
        assets::write_gltf(model, options.output);
    }
    for (const std::string& warning : warnings) {
        const std::string file = options.input.string() + ": ";
        log_warning(warning.starts_with(file) ? warning : file + warning);
    }
    return 0;
}

} // namespace hachure
