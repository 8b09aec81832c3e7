#pragma once

#include <hachure/runtime/assets/json_text.h>
#include <hachure/systems/scene/migrate_scene.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {

/// Whether a file is a scene, told by its name: it ends in ".scene.json".
[[nodiscard]] bool is_scene_name(const std::filesystem::path& file);

/// A scene file as text and as the document of the current version.
class SceneFile {
public:
    /// Throws Error for what is no JSON, no scene, of a version that is not known, or can't be migrated.
    [[nodiscard]] static SceneFile read(const std::filesystem::path& file);

    /// The same with the text given; `file` says what paths in it are relative to, and need not exist.
    [[nodiscard]] static SceneFile parse(const std::filesystem::path& file, std::string text);

    [[nodiscard]] const nlohmann::json& root() const { return migrated_ ? migration_.document : text_.root(); }
    [[nodiscard]] const assets::JsonText& text() const { return text_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

    /// The path that a path in this file means, without "." and "..".
    [[nodiscard]] std::filesystem::path resolve(std::string_view path) const;

    /// Where in the text the value of a pointer of `root()` stands.
    [[nodiscard]] std::string pointer_in_text(std::string_view pointer) const;
    [[nodiscard]] std::string where(std::string_view pointer) const { return text_.where(pointer_in_text(pointer)); }

private:
    SceneFile(std::filesystem::path file, assets::JsonText text);

    std::filesystem::path file_;
    assets::JsonText text_;
    bool migrated_ = false;
    MigratedScene migration_;
};

} // namespace hachure
