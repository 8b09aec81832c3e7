#pragma once

#include <hachure/runtime/ecs/entity.h>

#include <stdexcept>
#include <string_view>

namespace hachure {

/// A dead (or null) entity was used where a live one is required.
class DeadEntity : public std::logic_error {
public:
    explicit DeadEntity(Entity entity);
};

/// A live entity lacks the component that was asked for; the message names it.
class MissingComponent : public std::logic_error {
public:
    MissingComponent(Entity entity, std::string_view component);
};

/// The world holds no resource of the type that was asked for; the message names it.
class MissingResource : public std::logic_error {
public:
    explicit MissingResource(std::string_view resource);
};

/// An entity was to become its own ancestor.
class HierarchyCycle : public std::logic_error {
public:
    HierarchyCycle(Entity child, Entity parent);
};

} // namespace hachure
