#include <hachure/systems/convert/instance_entities.h>

#include <ranges>

namespace hachure {

InstanceEntities instance_entities(const World& world, const assets::Model& model, Entity root) {
    InstanceEntities result{std::vector(model.nodes.size(), Entity::null),
                            std::vector(model.nodes.size(), Entity::null)};
    struct Pending {
        std::int32_t node;
        Entity parent;
        std::size_t place;
    };
    std::vector<Pending> pending;
    std::size_t next_below_root = 0; // nodes and skinned surfaces take turns there
    const auto child = [&](Entity parent, std::size_t place) {
        const std::span<const Entity> children = world.children(parent);
        return place < children.size() ? children[place] : Entity::null;
    };
    const assets::Scene& scene = model.scenes[static_cast<std::size_t>(model.default_scene)];
    for (const std::int32_t node : scene.roots | std::views::reverse) pending.push_back({node, root, 0});
    while (!pending.empty()) {
        const auto [index, parent, place] = pending.back();
        pending.pop_back();
        const assets::Node& node = model.nodes[static_cast<std::size_t>(index)];
        const Entity entity = child(parent, parent == root ? next_below_root++ : place);
        if (!entity) continue;
        result.nodes[static_cast<std::size_t>(index)] = entity;
        if (node.mesh >= 0)
            result.surfaces[static_cast<std::size_t>(index)] = node.skin >= 0 ? child(root, next_below_root++) : entity;
        for (std::size_t i = node.children.size(); i-- > 0;) pending.push_back({node.children[i], entity, i});
    }
    return result;
}

} // namespace hachure
