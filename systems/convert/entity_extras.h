#pragma once

#include <hachure/systems/convert/world_to_model.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hachure {

/// Says as JSON what entities carry.
class EntityExtras {
public:
    /// All outlive this.
    EntityExtras(const App& app, const WorldToModel& what, std::vector<std::string>& warnings);

    /// By name the components (all that are reflected but transform, name, camera and light), the scene parts, whose
    /// files are relative to `folder`, and what scene files said that nobody knew.
    [[nodiscard]] nlohmann::json of(Entity entity, const std::filesystem::path& folder) const;

    /// The scene parts alone.
    [[nodiscard]] nlohmann::json parts_of(Entity entity, const std::filesystem::path& folder) const;

    /// What the file of its model said of the entity (components/model_extras.h).
    [[nodiscard]] nlohmann::json said_by_file(Entity entity) const;

    /// Names from the root down, "car/wheel"; empty where one has none.
    [[nodiscard]] std::string path_of(Entity entity) const;

    /// The path from the folder of the output to a file; a warning where readers of the output will refuse it.
    [[nodiscard]] std::string relative(const std::filesystem::path& file) const;

private:
    /// The fields that differ from what the entity has anyway; null where that is all of the component.
    [[nodiscard]] nlohmann::json component(Entity entity, const TypeInfo& type, const void* component) const;
    [[nodiscard]] const StyleComponent* styled(Entity entity, const TypeInfo& type) const;
    [[nodiscard]] nlohmann::json value(const FieldInfo& field, const FieldValue& value) const;
    const World& world_;
    const TypeRegistry& types_;
    const WorldToModel& what_;
    std::vector<std::string>& warnings_;
    std::filesystem::path folder_; ///< of the output
};

} // namespace hachure
