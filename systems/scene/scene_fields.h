#pragma once

#include <hachure/components/scene.h>
#include <hachure/runtime/ecs/reflect.h>
#include <hachure/systems/scene/scene_faults.h>

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hachure {

/// A field that holds an entity, as a scene says it: by a path of names.
struct NamedEntity {
    const FieldInfo* field = nullptr;
    std::string path;
    std::string pointer;
};

/// What a scene says of one component of an entity.
struct SaidComponent {
    const TypeInfo* type = nullptr;
    bool removed = false; ///< the entity shall have none
    FieldValues fields;   ///< in place of those that it has
    std::vector<NamedEntity> entities;
};

/// The components that scenes may name, found faster than a registry finds them.
class SceneTypes {
public:
    explicit SceneTypes(const TypeRegistry& types);

    /// Null when there is none.
    [[nodiscard]] const TypeInfo* find(std::string_view name) const;
    [[nodiscard]] const TypeRegistry& registry() const { return *types_; }

private:
    const TypeRegistry* types_;
    std::unordered_map<std::string_view, const TypeInfo*> by_name_;
};

/// Reads a component's value: null, or an object of fields; of the name also just the text. Unknown fields are put into
/// `unknown` and warned of. False where the value as a whole is none.
bool read_component(const TypeInfo& type, const nlohmann::json& value, const SceneFile& file,
                    const std::string& pointer, SceneFaults& faults, SaidComponent& said, nlohmann::json* unknown);

/// A set of components by name, as a look and an override have it. Unknown components are warned of and left out.
[[nodiscard]] std::vector<SaidComponent> read_components(const SceneTypes& types, const nlohmann::json& value,
                                                         const SceneFile& file, const std::string& pointer,
                                                         SceneFaults& faults);

/// The same set with every path of a file as `change` has it: what it means from anywhere, or relative to a folder
/// again. What is not of the expected form stays.
[[nodiscard]] nlohmann::json with_paths(const SceneTypes& types, nlohmann::json components,
                                        const std::function<std::string(const std::string&)>& change);

/// Makes the component of the entity as it was said, all but the fields that hold entities. False where nothing was
/// done, since only a model gives an entity a surface.
bool apply(World& world, Entity entity, const SaidComponent& said);

} // namespace hachure
