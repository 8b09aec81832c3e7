#include <hachure/runtime/error.h>
#include <hachure/systems/scene/scene_file.h>

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace hachure {
namespace {

/// Where what stands at `pointer` stood before a migration.
std::string pointer_before(const MovedPointers& moved, const std::string& pointer) {
    const MovedPointers::value_type* best = nullptr;
    for (const auto& move : moved) {
        const bool at_or_below = pointer.starts_with(move.first) &&
                                 (pointer.size() == move.first.size() || pointer[move.first.size()] == '/');
        if (at_or_below && (!best || move.first.size() > best->first.size())) best = &move;
    }
    return best ? best->second + pointer.substr(best->first.size()) : pointer;
}

} // namespace

bool is_scene_name(const std::filesystem::path& file) { return file.filename().string().ends_with(".scene.json"); }

SceneFile SceneFile::read(const std::filesystem::path& file) { return {file, assets::JsonText::read(file)}; }

SceneFile SceneFile::parse(const std::filesystem::path& file, std::string text) {
    return {file, assets::JsonText::parse(file.string(), std::move(text))};
}

SceneFile::SceneFile(std::filesystem::path file, assets::JsonText text)
    : file_(std::move(file)), text_(std::move(text)) {
    const nlohmann::json& root = text_.root();
    if (!root.is_object() || !root.contains("hachure_scene"))
        throw Error(text_.subject(), "is not a scene: it lacks \"hachure_scene\"");
    const nlohmann::json& version = root["hachure_scene"];
    if (!version.is_number_unsigned() || version.get<std::uint64_t>() > scene_version)
        text_.fail("/hachure_scene", fmt::format("the version is not one of 0 to {}", scene_version));
    const auto number = static_cast<int>(version.get<std::uint64_t>());
    migrated_ = number < scene_version;
    if (!migrated_) return;
    try {
        migration_ = migrate_scene(root, number);
    } catch (const std::invalid_argument& fault) {
        const std::string_view message = fault.what();
        const std::size_t end = message.find('\n');
        text_.fail(message.substr(0, end), message.substr(end + 1));
    }
}

std::filesystem::path SceneFile::resolve(std::string_view path) const {
    return (file_.parent_path() / std::filesystem::path(path)).lexically_normal();
}

std::string SceneFile::pointer_in_text(std::string_view pointer) const {
    std::string result(pointer);
    for (const MovedPointers& moved : migration_.moved) result = pointer_before(moved, result);
    return result;
}

} // namespace hachure
