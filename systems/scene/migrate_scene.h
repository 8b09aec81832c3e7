#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace hachure {

/// The version that this program writes.
inline constexpr int scene_version = 1;

/// What one migration moved: pointers of the newer document, and where the same stands in the older one. What is below
/// them moved along.
using MovedPointers = std::vector<std::pair<std::string, std::string>>;

/// A scene document as the current version would say it.
struct MigratedScene {
    nlohmann::json document;
    std::vector<MovedPointers> moved; ///< by migration, the last one first
};

/// Turns a document of `version`, which is older than `scene_version` and not negative, into the current one, one
/// version at a time. Throws std::invalid_argument with a pointer's fault, "POINTER\nFAULT", for what has no such
/// version's form.
///
/// Version 0 was a draft: a flat list, where each entity names the one that it hangs on.
///
///     { "hachure_scene": 0, "style": "gooch",
///       "objects": [ { "id": "Ground", "file": "ground.obj" },
///                    { "id": "Fox", "file": "fox.glb", "parent": "Ground", "position": [0, 1, 0],
///                      "components": { "animation": { "clip": "Run" } } } ] }
[[nodiscard]] MigratedScene migrate_scene(const nlohmann::json& document, int version);

} // namespace hachure
