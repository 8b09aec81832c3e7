#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <string>

namespace hachure {

/// What a user calls the entity: a glTF node's name, or "entity" in `--set entity/component.field=value`.
struct Name {
    std::string text;

    friend bool operator==(const Name&, const Name&) = default;
};

inline void reflect(TypeBuilder<Name>& type) {
    type.name("name").doc("what the entity is called");
    type.field("text", &Name::text).doc("the name");
}

} // namespace hachure
