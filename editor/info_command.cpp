#include <hachure/editor/info_command.h>
#include <hachure/editor/model_report.h>
#include <hachure/editor/scene_report.h>
#include <hachure/runtime/assets/image_sequence.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/scene/scene_file.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace hachure {
namespace {

void print_row(std::string_view name, const std::string& value) {
    const std::string row = fmt::format("{:<14} {}\n", name, value);
    std::fwrite(row.data(), 1, row.size(), stdout);
}

std::string names_of(const std::vector<assets::ImageChannel>& channels) {
    std::string names;
    for (const assets::ImageChannel& channel : channels) names += (names.empty() ? "" : " ") + channel.name;
    return names.empty() ? "none" : names;
}

/// What a decoded image has; throws for what is wrong with it.
void print_layers(const std::filesystem::path& file, const assets::ImageInfo& info) {
    const assets::LayeredImage image = assets::read_layers(file, {.color = true, .normal = true, .depth = true});
    const bool bytes = image.color->type == assets::PixelType::u8;
    print_row("size", fmt::format("{}x{}", info.size.width, info.size.height));
    print_row("channels", fmt::format("{} x {}", info.layers.color.size(), bytes ? "8 bit" : "float"));
    if (bytes) return;
    print_row("color", names_of(info.layers.color));
    print_row("normal", names_of(info.layers.normal));
    print_row("depth", names_of(info.layers.depth));
}

void print_image(const std::filesystem::path& file) {
    const assets::ImageInfo info = assets::read_image_info(file);
    print_row("file", file.string());
    print_row("kind", "image");
    print_layers(file, info);
}

void print_sequence(const std::filesystem::path& pattern) {
    const assets::ImageSequence sequence(pattern);
    const assets::NumberedFiles& files = sequence.files();
    print_row("file", pattern.string());
    print_row("kind", "numbered images");
    print_row("frames", fmt::format("{}, numbers {} to {}, {} missing", files.frame_count(), files.numbers().front(),
                                    files.numbers().back(), files.missing()));
    print_layers(files.file(0), sequence.info());
}

void print_video(const std::filesystem::path& file) {
    assets::VideoFile video(file);
    static_cast<void>(video.read_frame(0)); // says what is wrong with a file whose header alone is whole
    print_row("file", file.string());
    print_row("kind", "video");
    print_row("size", fmt::format("{}x{}", video.width(), video.height()));
    print_row("frames", fmt::format("{}", video.frame_count()));
    print_row("frames/s", fmt::format("{:.4g}", video.frames_per_second()));
}

} // namespace

void add_info_command(CLI::App& app, InfoOptions& options) {
    CLI::App* command = app.add_subcommand("info", "Tell what is in a file, and what is wrong with it");
    command
        ->add_option(
            "INPUT", options.input,
            "a scene (.scene.json), a model (glTF, GLB, OBJ, PLY, OFF, STL), an image, a video or numbered images "
            "(shot.####.exr)")
        ->required();
}

int run_info(const InfoOptions& options) {
    if (is_scene_name(options.input)) {
        for (const ReportRow& row : report_scene(options.input)) print_row(row.name, row.value);
        return 0;
    }
    switch (assets::input_kind(options.input)) {
    case assets::InputKind::image:
        if (assets::is_numbered_name(options.input))
            print_sequence(options.input);
        else
            print_image(options.input);
        break;
    case assets::InputKind::video:
        print_video(options.input);
        break;
    case assets::InputKind::model:
    case assets::InputKind::unknown:
        for (const ReportRow& row : report_model(options.input.string(), assets::read_model(options.input)))
            print_row(row.name, row.value);
        break;
    }
    return 0;
}

} // namespace hachure
