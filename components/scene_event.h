#pragma once

#include <hachure/runtime/ecs/entity.h>

#include <string>

namespace hachure {

/// Something that happened in a scene and has a name: a timeline passed an "event" action, a script sent one. Read with
/// EventReader<SceneEvent>.
struct SceneEvent {
    Entity entity; ///< whom it is about; null for the scene as a whole
    std::string name;
};

} // namespace hachure
