#pragma once

#include <nlohmann/json_fwd.hpp>

namespace hachure {

/// JSON schema (2020-12) of what read_timeline takes.
[[nodiscard]] nlohmann::json timeline_schema();

} // namespace hachure
