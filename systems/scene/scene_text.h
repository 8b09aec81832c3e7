#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace hachure {

/// JSON as scene files are written: two spaces a level, keys in the order given, what fits into 100 columns on one
/// line, numbers in the fewest digits that are read as the same, bytes that are no UTF-8 replaced. Reading the text and
/// writing it again gives the same text. Numbers are finite.
[[nodiscard]] std::string scene_text(const nlohmann::ordered_json& document);

} // namespace hachure
