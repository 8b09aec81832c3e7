#pragma once

#include <hachure/components/rig.h>
#include <hachure/runtime/animation/clip.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace hachure {

/// The entities that stand for things of a file.
struct PointerOwners {
    const std::vector<Entity>& surfaces;                ///< by node: what is drawn of it, or null
    const std::multimap<std::int32_t, Entity>& cameras; ///< by camera
    const std::multimap<std::int32_t, Entity>& lights;  ///< by light
};

/// Finds the fields that the pointers of a clip (KHR_animation_pointer) move: of cameras, lights and the visibility of
/// nodes. Each field of each entity becomes an element of `bound`; a pointer to something that no field stands for is
/// said in `warnings`, one line each.
void bind_pointers(const animation::Clip& clip, std::uint32_t index, const PointerOwners& owners,
                   std::vector<RigPointer>& bound, std::vector<std::string>& warnings);

} // namespace hachure
