#pragma once

#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/ecs/reflect.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {

/// Where a scene part is read from.
struct ScenePartSource {
    const assets::JsonText& text;       ///< the document
    std::string pointer;                ///< of the part's value in it
    const nlohmann::json& value;        ///< the same, found
    const TypeRegistry& types;          ///< of the program
    std::filesystem::path folder;       ///< of the scene file: what paths in it are relative to
    std::vector<std::string>& warnings; ///< for lines that name what is odd but no error, with its place
};

/// Something of an entity that a scene file says beside its reflected components, because it is more than a set of
/// fields: a timeline, a state machine. It stands in the entity's object under its name.
struct ScenePart {
    /// Lower case with underscores; its own among parts. Where a reflected component has it too, the part stands in the
    /// component's place: it is read and written, fields and all, and the component by itself is not.
    std::string name;
    std::string doc;       ///< one line
    nlohmann::json schema; ///< JSON schema (2020-12) of its value

    /// Gives `entity` what the source says. Throws Error with line and column. All entities of the scene exist by then.
    std::function<void(World& world, Entity entity, const ScenePartSource& source)> read;

    /// What `read` would need to make the entity as it is; nothing where the entity has none of it. What was read and
    /// not changed since is written as it was.
    std::function<std::optional<nlohmann::json>(const World& world, Entity entity)> write;
};

/// Resource: the parts that this program's scene files may have. A capability adds its own when it is registered.
struct SceneParts {
    std::vector<ScenePart> parts;

    /// Null when there is none.
    [[nodiscard]] const ScenePart* find(std::string_view name) const;
};

/// Adds a part to those of the world; one of the same name is our own mistake.
void add_scene_part(World& world, ScenePart part);

} // namespace hachure
