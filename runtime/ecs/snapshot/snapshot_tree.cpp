#include <hachure/runtime/ecs/snapshot/snapshot_tree.h>

#include <algorithm>

namespace hachure::detail {
namespace {

/// Where the children of one parent lie among all that were read.
struct Family {
    std::uint32_t begin = 0;
    std::uint32_t count = 0;
    bool has_parent = false;
};

struct Forest {
    std::vector<Family> families; ///< by place
    std::vector<std::uint32_t> children;
};

Forest read_forest(ByteReader& in, std::uint32_t entities) {
    Forest forest{std::vector<Family>(entities), {}};
    const auto parents = in.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < parents; ++i) {
        const auto parent = in.number<std::uint32_t>();
        const auto count = in.number<std::uint32_t>();
        if (parent >= entities || forest.families[parent].count != 0 || count == 0)
            in.fail("has a parent that does not live, twice, or without children");
        forest.families[parent].begin = static_cast<std::uint32_t>(forest.children.size());
        forest.families[parent].count = count;
        for (const std::uint32_t child : in.numbers<std::uint32_t>(count)) {
            if (child >= entities || forest.families[child].has_parent)
                in.fail("has a child that does not live, or that has two parents");
            forest.families[child].has_parent = true;
            forest.children.push_back(child);
        }
    }
    in.expect_end();
    return forest;
}

} // namespace

void write_tree(ByteWriter& out, const World& world, std::span<const std::uint32_t> place) {
    std::vector<Entity> parents;
    world.query<const Children>().each([&](Entity entity, const Children&) { parents.push_back(entity); });
    std::ranges::sort(parents);
    out.number(static_cast<std::uint32_t>(parents.size()));
    for (const Entity parent : parents) {
        const auto children = world.children(parent);
        out.number(place[parent.index]);
        out.number(static_cast<std::uint32_t>(children.size()));
        for (const Entity child : children) out.number(place[child.index]);
    }
}

std::vector<TreeLink> read_tree(ByteReader& in, std::uint32_t entities) {
    const Forest forest = read_forest(in, entities);
    std::vector<TreeLink> links;
    links.reserve(forest.children.size());
    const auto add_children = [&](std::uint32_t parent) {
        const Family& family = forest.families[parent];
        for (std::uint32_t i = 0; i < family.count; ++i) links.push_back({forest.children[family.begin + i], parent});
    };
    for (std::uint32_t place = 0; place < entities; ++place)
        if (!forest.families[place].has_parent) add_children(place);
    // Grows while it is walked: each link leads to the children of its child.
    for (std::size_t i = 0; i < links.size(); ++i) add_children(links[i].child);
    // What hangs below no root hangs in a circle.
    if (links.size() != forest.children.size()) in.fail("has an entity above itself");
    return links;
}

} // namespace hachure::detail
