#include <hachure/components/rig.h>
#include <hachure/runtime/scene/clip_store.h>
#include <hachure/systems/animation/animation_parts.h>

namespace hachure {

const animation::ClipSet* clips_of(const World& world, Entity entity) {
    const Rig* rig = world.find<Rig>(entity);
    const ClipStore* store = world.find_resource<ClipStore>();
    return rig && store ? &store->clips(rig->clips).set : nullptr;
}

void warn_of_unknown_clip(const World& world, Entity entity, const assets::JsonValue& name,
                          std::vector<std::string>& warnings) {
    const animation::ClipSet* clips = clips_of(world, entity);
    if (clips && !animation::find_clip(*clips, name.string()))
        warnings.push_back(name.text().subject() + ": the model has no clip " + assets::in_quotes(name.string()) +
                           " (" + name.where() + ")");
}

} // namespace hachure
