#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <vector>

namespace hachure {

/// What the model file that an entity came from says of it in its extras, beside what it is: components with some of
/// their fields. They have been applied; a style that is put on the entity later leaves them as they are.
struct ModelExtras {
    struct Component {
        const TypeInfo* type; ///< of the registry that the model was spawned with
        FieldValues fields;
    };
    std::vector<Component> components; ///< in the order in which they apply
};

} // namespace hachure
