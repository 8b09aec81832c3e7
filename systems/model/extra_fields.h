#pragma once

#include <hachure/components/name_index.h>
#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/ecs/world.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hachure {

/// Reads fields as the extras of model files have them: what tools for custom properties can say (1 for true, 3.0 for
/// an integer), entities as paths of names, files relative to the model's. A field that can't be used costs a warning,
/// not the others.
class ExtraFields {
public:
    /// All outlive this. `root` is the model's: of several entities of a name, the one below it is meant.
    ExtraFields(const World& world, Entity root, const std::filesystem::path& file, std::vector<std::string>& warnings)
        : world_(world), root_(root), file_(file), warnings_(warnings) {}

    /// `fields` is an object. `speaker` and `pointer` say where it stands.
    FieldValues read(const TypeInfo& type, const nlohmann::json& fields, const std::string& speaker,
                     const std::string& pointer);

private:
    /// Throws Error about the speaker.
    FieldValues read_one(const TypeInfo& type, const std::string& name, const nlohmann::json& value,
                         const JsonPlace& place);
    Entity entity_called(const std::string& path);

    const World& world_;
    Entity root_;
    const std::filesystem::path& file_;
    std::vector<std::string>& warnings_;
    NameIndex names_;
};

} // namespace hachure
