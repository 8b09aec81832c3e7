#include <hachure/runtime/assert.h>
#include <hachure/runtime/scene/scene_parts.h>

#include <algorithm>

namespace hachure {

const ScenePart* SceneParts::find(std::string_view name) const {
    const auto found = std::ranges::find(parts, name, &ScenePart::name);
    return found == parts.end() ? nullptr : &*found;
}

void add_scene_part(World& world, ScenePart part) {
    SceneParts* parts = world.find_resource<SceneParts>();
    if (!parts) parts = &world.set_resource(SceneParts{});
    HACHURE_ASSERT(!parts->find(part.name), "a scene part's name is its own");
    parts->parts.push_back(std::move(part));
}

} // namespace hachure
