#pragma once

#include <hachure/editor/play/play_result.h>

#include <nlohmann/json_fwd.hpp>

namespace hachure::play {

/// A result as JSON, and back: how a test's own process tells the one that started it. Numbers that JSON has not are
/// null for NaN, and "inf" or "-inf".
[[nodiscard]] nlohmann::json to_json(const PlayResult& result);

/// Throws nlohmann's exceptions for what to_json did not write.
[[nodiscard]] PlayResult result_from_json(const nlohmann::json& json);

} // namespace hachure::play
