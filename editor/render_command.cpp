#include <hachure/editor/assignments.h>
#include <hachure/editor/finished_frames.h>
#include <hachure/editor/frame_output.h>
#include <hachure/editor/frame_plan.h>
#include <hachure/editor/frame_share.h>
#include <hachure/editor/frame_stats.h>
#include <hachure/editor/frame_walk.h>
#include <hachure/editor/input_film.h>
#include <hachure/editor/interrupt.h>
#include <hachure/editor/open_input.h>
#include <hachure/editor/playback_clock.h>
#include <hachure/editor/render_command.h>
#include <hachure/editor/render_outputs.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/app/progress.h>
#include <hachure/runtime/assets/frame_pattern.h>
#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/parallel.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/styles/style.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <optional>

namespace hachure {
namespace {

constexpr int max_side = 16384;
constexpr int max_threads = 1024;

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

/// An image or a video keeps its size, unless another is asked for.
Canvas canvas_for(const RenderOptions& options) {
    if (!options.size.empty()) return parse_size(options.size);
    if (!is_picture_name(options.input)) return {};
    const Canvas canvas = picture_size(options.input);
    if (canvas.width > max_side || canvas.height > max_side)
        throw Error(options.input.string(), fmt::format("has {}x{} pixels, at most {} a side can be drawn: use --size",
                                                        canvas.width, canvas.height, max_side));
    return canvas;
}

/// A film, or a picture for each frame.
bool takes_all_frames(const std::filesystem::path& output) {
    const auto format = assets::frame_format(output);
    return (format && assets::is_film(*format)) || assets::count_number_fields(output) > 0;
}

/// Frames of a video or of numbered images come at their own rate, unless another is asked for, and all of them where
/// the output takes them and none are asked for.
FramePlan plan_for(const RenderOptions& options, std::span<const Assignment> assignments) {
    FramePlan plan = parse_frame_plan(options.frames, options.time, options.fps.empty() ? "30" : options.fps);
    const bool all = options.frames.empty() && options.time.empty() && takes_all_frames(options.output);
    if (!all && !options.fps.empty()) return plan;
    const std::optional<InputFilm> film = input_film(options.input, assignments);
    if (!film) return plan;
    const assets::FrameRate rate = options.fps.empty() ? film->rate : plan.rate;
    if (all) plan = parse_frame_plan(fmt::format("0..{}", film->frames_at(rate) - 1), "", "30");
    plan.rate = rate;
    return plan;
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

void check_size(const RenderOptions& options, Canvas canvas, const gpu::Context& context) {
    const int limit = context.limits().max_texture_size;
    if (canvas.width > limit || canvas.height > limit)
        throw Error(options.size.empty() ? options.input.string() : "--size",
                    "this driver draws at most " + std::to_string(limit) + " pixels a side");
}

/// A whole scene, ready to be drawn.
void load_scene(App& app, const RenderOptions& options, std::span<const Assignment> assignments, Canvas canvas) {
    OpenOptions open{options.style, std::nullopt};
    // Who asks for a moment, or for many, wants to see what moves.
    if (!options.clip.empty() || !options.frames.empty() || !options.time.empty()) open.clip = options.clip;
    open_input(app, options.input, canvas, open);
    apply_assignments(app.world(), assignments);
}

/// What one run draws.
struct Work {
    FramePlan plan;                   ///< its share of all frames
    std::vector<std::int64_t> frames; ///< those of the plan that are wanted, ascending
};

/// Nothing, and a line on stdout that says why, where no frame is left to draw.
std::optional<Work> find_work(App& app, const RenderOptions& options, const FramePlan& all,
                              const RenderOutputs& outputs, Canvas canvas) {
    Work work{all, {}};
    if (!options.chunk.empty()) {
        const std::optional<FramePlan> share = share_of(all, parse_frame_share(options.chunk));
        if (!share) {
            fmt::print("share {} of {} frames holds none: nothing to do\n", options.chunk, all.count());
            return {};
        }
        work.plan = *share;
    }
    if (options.resume) {
        Progress progress("looking at what is there");
        work.frames = missing_frames(app, outputs, work.plan, canvas, progress);
        if (work.frames.empty()) fmt::print("all {} frames are there: nothing to do\n", work.plan.count());
        return work.frames.empty() ? std::nullopt : std::optional(work);
    }
    for (std::int64_t number = work.plan.first; number <= work.plan.last; ++number) work.frames.push_back(number);
    return work;
}

FrameHistory history_of(const App& app) {
    if (needs_stepping(app)) return FrameHistory::whole;
    return app.world().resource<FrameRequests>().wants("velocity") ? FrameHistory::motion : FrameHistory::none;
}

/// Draws the frames, hands them on, and writes the statistics when there is a file for them.
void draw_frames(App& app, Renderer& renderer, const Work& work, const RenderOutputs& outputs, Progress& progress) {
    const InterruptWatch watch;
    FrameOutput output(app, renderer, outputs, work.plan);
    std::vector<FrameStats> stats;
    std::size_t done = 0;
    const auto draw = [&](const FrameStep& step) {
        if (work.frames.size() > 1) progress.step(done, work.frames.size());
        const FrameClock clock;
        renderer.render_frame(seek(app, step.seconds));
        if (!outputs.stats.empty()) {
            renderer.finish();
            stats.push_back(frame_stats(app, renderer, clock.milliseconds()));
        }
        output.take(step.number);
        ++done;
    };
    const FrameHistory history = history_of(app);
    progress.stage(history == FrameHistory::whole ? "stepping" : "drawing");
    walk_frames(work.plan, work.frames, history, [&](const FrameStep& step) {
        stop_when_interrupted();
        if (step.drawn && done == 0) progress.stage("drawing");
        if (step.drawn) return draw(step);
        if (history == FrameHistory::whole && done == 0 && !work.plan.time)
            progress.step(static_cast<std::size_t>(step.number), static_cast<std::size_t>(work.frames.front()));
        renderer.skip_frame(seek(app, step.seconds));
    });
    progress.stage("writing");
    if (!outputs.stats.empty()) write_stats(outputs.stats, stats, renderer.memory());
    output.finish();
}

} // namespace

void add_render_command(CLI::App& app, RenderOptions& options) {
    CLI::App* command =
        app.add_subcommand("render", "Render a scene, a model, an image, a video or numbered images in a style to a "
                                     "picture, pictures or a film");
    command
        ->add_option(
            "INPUT", options.input,
            "a scene (.scene.json), a glTF, GLB, OBJ, PLY, OFF or STL file, an image, a video, or numbered images: "
            "shot.####.exr")
        ->required();
    command
        ->add_option(
            "-o,--output", options.output,
            "a picture, .png (sRGB) or .exr (linear float), or its lines, .svg (those of abstracted_lines), numbered "
            "when the name has #s: out.####.png; or a film of all --frames, .gif or .mp4 (H.264; odd sizes get "
            "a row or column more)")
        ->required();
    command->add_option("--style", options.style,
                        "a style (see `hachure list styles`) or a preset FILE.json "
                        "(default: the scene's own, else gooch; lines for an image or a video)");
    command->add_option("--size", options.size,
                        "WIDTHxHEIGHT of the picture, pixels (default: that of an image or a video, else 1024x768)");
    command->add_option("--backend", options.backend, "where the OpenGL context comes from: auto, egl, osmesa, glfw")
        ->capture_default_str();
    CLI::Option* frames = command->add_option(
        "--frames", options.frames,
        "A..B: draw these frames, both included, or one: A; frame k shows second k / fps (default: all of a video or "
        "of numbered images, where the output is a film or numbered, else frame 0)");
    command->add_option("--time", options.time, "S: draw the picture of second S (default: 0)")->excludes(frames);
    command->add_option("--fps", options.fps,
                        "frames per second, 1 to 1000: 25, 29.97, 30000/1001; a .gif's at most 50 (default: that of a "
                        "video or of numbered images, else 30)");
    command->add_option("--clip", options.clip,
                        "NAME: the clip of the file that plays (default with --frames or --time: its first)");
    command
        ->add_option("--aov", options.aovs,
                     "NAME=FILE.exr: also write a buffer of the frame (see `hachure list aovs`); with several frames "
                     "FILE has #s")
        ->allow_extra_args(false);
    command
        ->add_option("--set", options.sets,
                     "PATH=VALUE: set component.field of all entities that carry it, or entity/component.field")
        ->allow_extra_args(false);
    command->add_option(
        "--chunk", options.chunk,
        "I/N: draw only share I (1 to N) of the frames of a numbered sequence; other runs draw the rest");
    command->add_flag("--resume", options.resume,
                      "keep the whole frames of a numbered sequence that are there and draw the others");
    command->add_option("--stats", options.stats, "FILE.json: times and passes of each drawn frame, memory");
    command->add_option("--threads", options.threads, "use at most N threads (default: all); the picture is the same")
        ->type_name("N")
        ->check(CLI::Range(1, max_threads));
    command->footer("Examples: hachure render bunny.obj -o bunny.png --style gooch --set gooch.b=0.55 --size 1024x768\n"
                    "          hachure render bunny.obj -o bunny.svg --style lines\n"
                    "          hachure render fox.glb -o fox.mp4 --frames 0..119 --fps 30\n"
                    "          hachure render photo.jpg -o photo.png --style lines\n"
                    "          hachure render shot.####.exr -o shot.mp4 --style lines --fps 24\n"
                    "          hachure render fox.glb -o fox.####.png --frames 0..119 --aov depth=depth.####.exr\n"
                    "          hachure render fox.glb -o fox.####.png --frames 0..119 --chunk 2/4 --resume");
}

int run_render(const RenderOptions& options) {
    if (!options.size.empty()) static_cast<void>(parse_size(options.size)); // wrong usage comes before wrong files
    const gpu::Backend backend = parse_backend(options.backend);
    const RenderOutputs outputs{options.output, parse_aovs(options.aovs), options.stats};
    if (options.threads > 0) set_thread_limit(options.threads);
    std::unique_ptr<gpu::Context> context; // outlives the app, whose world owns GPU objects
    App app;
    register_capabilities(app);
    const std::vector<Assignment> assignments = parse_assignments(app.types(), options.sets);
    const FramePlan plan = plan_for(options, assignments);
    if (!options.style.empty()) {
        check_style_name(options.style);
        static_cast<void>(find_style(app.types(), options.style)); // says what is wrong with it before all else
    }
    check_outputs(app, outputs, plan);
    if (!options.chunk.empty()) check_sequence("--chunk", outputs, plan);
    if (options.resume) check_sequence("--resume", outputs, plan);
    const Canvas canvas = canvas_for(options);
    const std::optional<Work> work = find_work(app, options, plan, outputs, canvas);
    if (!work) return 0;

    Progress progress("reading " + options.input.filename().string());
    load_scene(app, options, assignments, canvas);
    progress.stage("preparing");
    context = gpu::make_context(context_options(backend, canvas));
    check_size(options, canvas, *context);
    Renderer renderer(app, *context);
    draw_frames(app, renderer, *work, outputs, progress);
    return 0;
}

} // namespace hachure
