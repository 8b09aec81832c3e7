#include <hachure/tests/runtime/ecs/world_model/world_model.h>

namespace hachure::test::model {

bool WorldModel::has(Entity entity, int kind) const {
    const auto found = nodes.find(entity);
    return found != nodes.end() && found->second.cells[kind].has_value();
}

std::vector<Entity> WorldModel::entities() const {
    std::vector<Entity> result;
    for (const auto& [entity, node] : nodes) result.push_back(entity);
    return result;
}

void WorldModel::put(Entity entity, int kind, std::uint32_t number) {
    auto& cell = nodes.at(entity).cells[kind];
    cell = Cell{number, cell ? cell->added : tick, tick};
}

void WorldModel::remove(Entity entity, int kind) {
    nodes.at(entity).cells[kind].reset();
    removals.push_back({kind, entity, tick});
}

void WorldModel::destroy(Entity entity) {
    unlink(entity);
    while (!nodes.at(entity).children.empty()) destroy(nodes.at(entity).children.back());
    for (int kind = 0; kind < kinds; ++kind)
        if (has(entity, kind)) remove(entity, kind);
    nodes.erase(entity);
}

void WorldModel::clear() {
    while (!nodes.empty()) destroy(nodes.begin()->first);
}

bool WorldModel::contains(Entity ancestor, Entity entity) const {
    for (; entity; entity = nodes.at(entity).parent)
        if (entity == ancestor) return true;
    return false;
}

void WorldModel::link(Entity entity, Entity parent) {
    if (nodes.at(entity).parent == parent) return;
    unlink(entity);
    nodes.at(entity).parent = parent;
    nodes.at(parent).children.push_back(entity);
}

void WorldModel::unlink(Entity entity) {
    Node& node = nodes.at(entity);
    if (node.parent) std::erase(nodes.at(node.parent).children, entity);
    node.parent = Entity::null;
}

void WorldModel::forget_removed_before(Tick before) {
    std::erase_if(removals, [before](const Removal& removal) { return removal.tick < before; });
}

} // namespace hachure::test::model
