#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hachure::assets {

/// Checks all that the reader uses of a glTF document: the type and range of every property, that every index points
/// into its array, that every buffer view lies in its buffer. What passes can be converted and indexed without further
/// thought; only what lies in the buffers, and the shape of the node graph, is left to check. Sizes are at most 2 GiB.
///
/// Integers written as 4.0 are rewritten as 4. Throws hachure::Error about `file` with the JSON pointer of the first
/// fault, and for a version other than 2.x or a required extension that is not understood.
void check_gltf(nlohmann::json& document, const std::string& file);

/// Whether the reader understands the extension (data and all).
[[nodiscard]] bool understands_extension(std::string_view name);

} // namespace hachure::assets
