#pragma once

#include <hachure/runtime/assets/gltf_warnings.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hachure::assets {

/// Longest extras of one object, in bytes of JSON.
constexpr std::size_t max_extras_bytes = std::size_t{1} << 20;

/// What an object of a glTF file says to Hachure in its `extras`, as the text of one JSON object: by the name of a
/// component (or part of a scene, or setting) its fields. Empty when it says nothing. All ways to write it mean
/// the same, since tools for custom properties know only some of them:
///
///     "extras": {"hachure": {"gooch": {"b": 0.5}, "edge_lines": true}}        true: with its defaults
///     "extras": {"hachure": "{\"gooch\": {\"b\": 0.5}, \"edge_lines\": {}}"}    a text that holds JSON
///     "extras": {"hachure.gooch.b": 0.5, "hachure.edge_lines": 1}              a key per field; 0 and false: without
///     it
///
/// Where one object has several of them, those with longer keys add to those with shorter ones. Knows nothing of
/// components: what the names and values are worth is for whoever makes entities of them. Texts that are no JSON, and
/// extras longer than max_extras_bytes, are left out with a warning that names `where`, the pointer of `object`.
[[nodiscard]] std::string hachure_extras(const nlohmann::json& object, const std::string& where,
                                         GltfWarnings& warnings);

} // namespace hachure::assets
