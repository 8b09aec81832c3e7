#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/image_sequence.h>
#include <hachure/runtime/assets/numbered_files.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/file_fields.h>

#include <string_view>

namespace hachure {

namespace {

constexpr std::string_view image_file = "image file", image_or_video = "image or video file";

} // namespace

bool is_file_field(const FieldInfo& field) {
    return field.kind == FieldKind::text &&
           (field.unit == "file" || field.unit == image_file || field.unit == image_or_video);
}

std::string file_fault(const FieldInfo& field, const std::filesystem::path& file) {
    if ((field.unit != image_file && field.unit != image_or_video) || file.empty()) return {};
    try {
        if (field.unit == image_or_video && assets::is_video_name(file))
            static_cast<void>(assets::VideoFile(file).read_frame(0));
        else if (field.unit == image_or_video && assets::is_numbered_name(file))
            static_cast<void>(
                assets::ImageSequence(file).read_frame(0, {.color = true, .normal = true, .depth = true}));
        else
            static_cast<void>(assets::read_image(file));
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

} // namespace hachure
