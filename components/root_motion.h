#pragma once

#include <hachure/runtime/animation/root_motion.h>
#include <hachure/runtime/ecs/reflect.h>

#include <string>

namespace hachure {

/// Lets the motion of a joint move the whole model instead: the Transform of the root that carries it.
struct RootMotion {
    std::string joint; ///< the joint's node; empty for the first one that is a joint of a skin
    bool horizontal = true;
    bool vertical = false;
    animation::RootRotation rotation = animation::RootRotation::yaw;

    friend bool operator==(const RootMotion&, const RootMotion&) = default;
};

inline void reflect(TypeBuilder<RootMotion>& type) {
    type.name("root_motion").doc("lets the clips' motion of a joint move the whole model");
    type.field("joint", &RootMotion::joint).doc("name of the joint; empty for the top one of the skeleton");
    type.field("horizontal", &RootMotion::horizontal).doc("takes translation along the ground");
    type.field("vertical", &RootMotion::vertical).doc("takes translation up and down");
    type.field("rotation", &RootMotion::rotation).doc("which rotation it takes").options({"none", "yaw", "full"});
}

} // namespace hachure
