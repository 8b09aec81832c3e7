#pragma once

#include <hachure/runtime/ecs/storage.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

/// What a world remembers of the scene file that it came from, so that it can be written again.
namespace hachure {

/// On an entity with something below it that stands in a file of its own.
struct SceneReference {
    std::filesystem::path file; ///< a model, or another scene
    bool is_scene = false;
    std::string own_name; ///< what the entity is called when the scene gives it no name
    /// Components by path of names below the entity, as the scene file has them; paths of files are resolved. An
    /// object.
    nlohmann::json overrides = nlohmann::json::object();
};

/// What else a scene file says of an entity that no component holds.
struct SceneExtras {
    std::string look; ///< of the surfaces at and below the entity; empty for none
    /// What this program does not know, kept: keys of the entity, and by component the fields that it lacks. An object.
    nlohmann::json unknown = nlohmann::json::object();
};

/// A scene file does not tell of the entity: it came with a model or another scene that the file names, or a program
/// added it for its own, as a camera that frames what there is.
struct Unsaved {
    static constexpr auto storage = Storage::sparse;
};

/// Resource: what a scene file says of the whole.
struct SceneDocument {
    std::filesystem::path file; ///< that it was read from; empty for a world that was made otherwise
    std::string doc;            ///< one line; may be empty
    std::string style;          ///< a name or a resolved path, as the file says; empty for none
    std::string applied_style;  ///< what surfaces and cameras carry; empty for none
    nlohmann::json looks = nlohmann::json::object();   ///< by name, as the file has them; paths of files are resolved
    nlohmann::json unknown = nlohmann::json::object(); ///< keys that this program does not know
};

} // namespace hachure
