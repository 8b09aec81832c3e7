#include <hachure/runtime/ecs/ecs_error.h>

#include <fmt/format.h>

namespace hachure {

DeadEntity::DeadEntity(Entity entity) : std::logic_error(fmt::format("entity {} is dead", to_string(entity))) {}

MissingComponent::MissingComponent(Entity entity, std::string_view component)
    : std::logic_error(fmt::format("entity {} has no {}", to_string(entity), component)) {}

MissingResource::MissingResource(std::string_view resource)
    : std::logic_error(fmt::format("the world has no resource {}", resource)) {}

HierarchyCycle::HierarchyCycle(Entity child, Entity parent)
    : std::logic_error(fmt::format("entity {} cannot become a child of {}, which it is or contains", to_string(child),
                                   to_string(parent))) {}

} // namespace hachure
