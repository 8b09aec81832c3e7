#include <hachure/tests/benchmarks/ecs_groups.h>

namespace hachure::bench {

const std::vector<std::function<Group(std::size_t)>>& all_groups() {
    static const std::vector<std::function<Group(std::size_t)>> groups{
        iterate_group, create_group, destroy_group, component_group, access_group,
        write_group,   change_group, tree_group,    footprint_group,
    };
    return groups;
}

} // namespace hachure::bench
