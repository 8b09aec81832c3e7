#pragma once

#include <hachure/runtime/ecs/world.h>

#include <nlohmann/json.hpp>

namespace hachure {

class TypeRegistry;

/// The JSON schema (2020-12) of scene files as this program reads them: its components with their fields' docs, ranges
/// and options, and the world's scene parts. Editors that know schemas complete and check scene files with it.
[[nodiscard]] nlohmann::ordered_json scene_schema(const World& world, const TypeRegistry& types);

} // namespace hachure
