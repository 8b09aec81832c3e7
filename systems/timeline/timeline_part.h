#pragma once

#include <hachure/runtime/scene/scene_parts.h>

namespace hachure {

/// The part "timeline" of scene files: a Timeline with its document, in the entity itself or in a file of its own.
[[nodiscard]] ScenePart timeline_part();

} // namespace hachure
