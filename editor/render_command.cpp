#include <hachure/editor/assignments.h>
#include <hachure/editor/frame_stats.h>
#include <hachure/editor/load_model.h>
#include <hachure/editor/render_command.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/app/progress.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/parallel.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/styles/style.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <optional>

namespace hachure {
namespace {

constexpr int max_side = 16384;
constexpr int max_threads = 1024;

struct AovOutput {
    std::string name;
    std::filesystem::path file;
};

Canvas parse_size(const std::string& text) {
    Canvas canvas{};
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, canvas.width);
    const bool cross = width.ec == std::errc{} && width.ptr != end && (*width.ptr == 'x' || *width.ptr == 'X');
    const auto height = cross ? std::from_chars(width.ptr + 1, end, canvas.height) : width;
    if (!cross || height.ec != std::errc{} || height.ptr != end || canvas.width < 1 || canvas.height < 1)
        throw UsageError("--size: '" + text + "' is not WIDTHxHEIGHT");
    if (canvas.width > max_side || canvas.height > max_side)
        throw UsageError("--size: at most " + std::to_string(max_side) + " pixels a side");
    return canvas;
}

gpu::Backend parse_backend(const std::string& text) {
    const std::optional<gpu::Backend> backend = gpu::backend_from_string(text);
    if (!backend) throw UsageError("--backend: '" + text + "' is none of auto, egl, osmesa, glfw");
    return *backend;
}

std::vector<AovOutput> parse_aovs(const std::vector<std::string>& texts) {
    std::vector<AovOutput> outputs;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
            throw UsageError("--aov: '" + text + "' is not NAME=FILE.exr");
        outputs.push_back({text.substr(0, equals), text.substr(equals + 1)});
        if (assets::lower_extension(outputs.back().file) != ".exr")
            throw UsageError("--aov: '" + outputs.back().file.string() + "' is not an .exr file");
    }
    return outputs;
}

void check_aov_names(App& app, const std::vector<AovOutput>& aovs) {
    const std::vector<AovInfo>& known = frame_requests(app.world()).known;
    for (const AovOutput& aov : aovs)
        if (std::ranges::find(known, aov.name, &AovInfo::name) == known.end())
            throw UsageError("--aov: there is no AOV '" + aov.name + "' (see hachure list aovs)");
}

void check_writable(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.parent_path().empty() ? "." : file.parent_path();
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw Error(file.string(), "can't be written: there is no such folder");
    if (std::filesystem::is_directory(file, ignored)) throw Error(file.string(), "is a folder, not a file to write");
}

/// A name is a matter of usage, a preset file one of the file.
void check_style_name(const std::string& name) {
    if (std::filesystem::path(name).extension() == ".json") return;
    std::string known;
    for (const BuiltInStyle& style : built_in_styles()) {
        if (name == style.name) return;
        known += std::string(style.name) + ", ";
    }
    throw UsageError("--style: there is no style '" + name + "'; there are " + known + "or a preset FILE.json");
}

/// Before any work: what would fail at its end.
void check_outputs(const RenderOptions& options, const std::vector<AovOutput>& aovs) {
    const std::string extension = assets::lower_extension(options.output);
    if (extension != ".png" && extension != ".exr")
        throw UsageError("-o: '" + options.output.string() + "' is neither a .png nor an .exr file");
    std::vector<std::filesystem::path> files{options.output};
    for (const AovOutput& aov : aovs) files.push_back(aov.file);
    if (!options.stats.empty()) files.push_back(options.stats);
    for (const std::filesystem::path& file : files) {
        if (std::ranges::count(files, file) > 1) throw UsageError("'" + file.string() + "' would be written twice");
        check_writable(file);
    }
}

gpu::ContextOptions context_options(gpu::Backend backend, Canvas canvas) {
    gpu::ContextOptions options;
    options.backend = backend;
    options.width = canvas.width;
    options.height = canvas.height;
    options.visible = false;
    options.vsync = false;
    return options;
}

void check_size(Canvas canvas, const gpu::Context& context) {
    const int limit = context.limits().max_texture_size;
    if (canvas.width > limit || canvas.height > limit)
        throw Error("--size", "this driver draws at most " + std::to_string(limit) + " pixels a side");
}

void write_aov(Renderer& renderer, const FrameRequests& requests, const AovOutput& aov) {
    const auto info = std::ranges::find(requests.known, aov.name, &AovInfo::name);
    assets::write_exr(aov.file, renderer.read_aov(aov.name), info->channel_names);
}

} // namespace

void add_render_command(CLI::App& app, RenderOptions& options) {
    CLI::App* command = app.add_subcommand("render", "Render a model in a style to a picture");
    command->add_option("INPUT", options.input, "a glTF, GLB, OBJ, PLY, OFF or STL file")->required();
    command->add_option("-o,--output", options.output, "the picture: .png (sRGB) or .exr (linear float)")->required();
    command->add_option("--style", options.style, "a style (see `hachure list styles`) or a preset FILE.json")
        ->capture_default_str();
    command->add_option("--size", options.size, "WIDTHxHEIGHT of the picture, pixels")->capture_default_str();
    command->add_option("--backend", options.backend, "where the OpenGL context comes from: auto, egl, osmesa, glfw")
        ->capture_default_str();
    command
        ->add_option("--aov", options.aovs, "NAME=FILE.exr: also write a buffer of the frame (see `hachure list aovs`)")
        ->allow_extra_args(false);
    command
        ->add_option("--set", options.sets,
                     "PATH=VALUE: set component.field of all entities that carry it, or entity/component.field")
        ->allow_extra_args(false);
    command->add_option("--stats", options.stats, "FILE.json: times, passes and memory of the frame");
    command->add_option("--threads", options.threads, "use at most N threads (default: all); the picture is the same")
        ->type_name("N")
        ->check(CLI::Range(1, max_threads));
    command->footer("Example: hachure render bunny.obj -o bunny.png --style gooch --set gooch.b=0.55 --size 1024x768");
}

int run_render(const RenderOptions& options) {
    const Canvas canvas = parse_size(options.size);
    const gpu::Backend backend = parse_backend(options.backend);
    const std::vector<AovOutput> aovs = parse_aovs(options.aovs);
    if (options.threads > 0) set_thread_limit(options.threads);
    std::unique_ptr<gpu::Context> context; // outlives the app, whose world owns GPU objects
    App app;
    register_capabilities(app);
    const std::vector<Assignment> assignments = parse_assignments(app.types(), options.sets);
    check_style_name(options.style);
    const Style style = find_style(app.types(), options.style);
    check_aov_names(app, aovs);
    check_outputs(options, aovs);
    if (const assets::InputKind kind = assets::input_kind(options.input);
        kind == assets::InputKind::image || kind == assets::InputKind::video)
        throw Error(options.input.string(),
                    "style '" + options.style + "' draws models; an image or a video has no surfaces");

    Progress progress("reading " + options.input.filename().string());
    const assets::Model model = assets::read_model(options.input);
    progress.stage("preparing");
    context = gpu::make_context(context_options(backend, canvas));
    check_size(canvas, *context);
    Renderer renderer(app, *context);
    load_model(app, model, options.input, canvas);
    apply_style(app.world(), app.types(), style);
    apply_assignments(app.world(), assignments);

    const bool exr = assets::lower_extension(options.output) == ".exr";
    for (const AovOutput& aov : aovs) renderer.request_aov(aov.name);
    if (exr) renderer.request_aov("color");
    progress.stage("drawing");
    FrameClock clock;
    renderer.render_frame();
    renderer.finish();
    const double frame_ms = clock.milliseconds();

    progress.stage("writing");
    const FrameRequests& requests = app.world().resource<FrameRequests>();
    for (const AovOutput& aov : aovs) write_aov(renderer, requests, aov);
    if (!options.stats.empty()) {
        const FrameStats stats = frame_stats(app, renderer, frame_ms);
        write_stats(options.stats, std::span(&stats, 1), renderer.memory());
    }
    if (exr)
        write_aov(renderer, requests, {"color", options.output});
    else
        assets::write_png(options.output, renderer.read_picture());
    return 0;
}

} // namespace hachure
