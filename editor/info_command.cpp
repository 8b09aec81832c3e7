#include <hachure/editor/info_command.h>
#include <hachure/editor/model_report.h>
#include <hachure/editor/scene_report.h>
#include <hachure/runtime/assets/image_file.h>
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

void print_image(const std::filesystem::path& file) {
    const assets::Image image = assets::read_image(file);
    print_row("file", file.string());
    print_row("kind", "image");
    print_row("size", fmt::format("{}x{}", image.width, image.height));
    print_row("channels",
              fmt::format("{} x {}", image.channels, image.type == assets::PixelType::u8 ? "8 bit" : "float"));
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
        ->add_option("INPUT", options.input,
                     "a scene (.scene.json), a model (glTF, GLB, OBJ, PLY, OFF, STL), an image or a video")
        ->required();
}

int run_info(const InfoOptions& options) {
    if (is_scene_name(options.input)) {
        for (const ReportRow& row : report_scene(options.input)) print_row(row.name, row.value);
        return 0;
    }
    switch (assets::input_kind(options.input)) {
    case assets::InputKind::image:
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
