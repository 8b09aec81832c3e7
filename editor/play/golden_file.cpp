#include <hachure/editor/play/golden_file.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <algorithm>

namespace hachure::play {
namespace {

/// A path that stays where it is relative to, whatever the file says.
bool stays_inside(const std::filesystem::path& path) {
    const std::string& text = path.native();
    return path.is_relative() && text.find('\\') == text.npos && text.find('\0') == text.npos &&
           std::ranges::find(path, "..") == path.end();
}

} // namespace

std::filesystem::path parse_picture_path(JsonObject& object, const std::string& key,
                                         const std::filesystem::path& folder, const std::string& extension) {
    const std::filesystem::path path = object.text(key);
    if (!stays_inside(path)) object.fail(key, key + " is no path below the test's folder");
    if (assets::lower_extension(path) != extension) object.fail(key, key + " is no " + extension + " file");
    return folder / path;
}

std::filesystem::path parse_mask(JsonObject& object, const std::filesystem::path& folder) {
    return object.find("mask") ? parse_picture_path(object, "mask", folder, ".png") : std::filesystem::path();
}

GoldenFile read_golden(const std::filesystem::path& file, int width, int height, int channels, assets::PixelType type) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return {std::nullopt, "there is no " + file.string()};
    try {
        assets::Image image = assets::read_image(file);
        if (image.width != width || image.height != height)
            return {std::nullopt, fmt::format("{} has {}x{} pixels, the picture {}x{}", file.string(), image.width,
                                              image.height, width, height)};
        const bool fits = image.type == type && (channels == 0 || image.channels == channels);
        if (!fits) return {std::nullopt, file.string() + " has other channels than the picture"};
        return {std::move(image), {}};
    } catch (const Error& error) {
        return {std::nullopt, error.what()};
    }
}

bool identical(const assets::Image& a, const assets::Image& b) {
    return a.width == b.width && a.height == b.height && a.channels == b.channels && a.type == b.type &&
           a.pixels == b.pixels;
}

void make_folder_of(const std::filesystem::path& file) {
    std::error_code fault;
    if (!file.parent_path().empty()) std::filesystem::create_directories(file.parent_path(), fault);
    if (fault) throw Error(file.string(), "its folder can't be made", fault.message());
}

} // namespace hachure::play
