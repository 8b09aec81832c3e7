#include <hachure/runtime/ecs/access.h>

#include <algorithm>
#include <utility>

namespace hachure {
namespace {

using Items = std::vector<Access::Item>;

bool any_written(const Items& items) { return std::ranges::any_of(items, &Access::Item::writes); }

/// Calls `f(item)` for each type in both lists that one of them writes, until f returns false.
template <class F> void for_each_clash(const Items& a, const Items& b, F&& f) {
    for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
        if (i->id == j->id && (i->writes || j->writes) && !f(*i)) return;
        const bool first_is_less = i->id < j->id;
        if (i->id <= j->id) ++i;
        if (!first_is_less) ++j;
    }
}

bool clash(const Items& a, const Items& b) {
    bool found = false;
    for_each_clash(a, b, [&found](const Access::Item&) {
        found = true;
        return false;
    });
    return found;
}

void add_clashes(const Items& a, const Items& b, std::vector<std::string_view>& names) {
    for_each_clash(a, b, [&names](const Access::Item& item) {
        names.push_back(item.name);
        return true;
    });
}

/// Reserving entities moves the table that a reader of the world looks handles up in.
bool contest_entities(const Access& a, const Access& b) {
    return (a.commands && (b.commands || b.reads_world)) || (b.commands && a.reads_world);
}

void add_written(const Items& items, std::vector<std::string_view>& names) {
    for (const Access::Item& item : items)
        if (item.writes) names.push_back(item.name);
}

} // namespace

void Access::add(std::vector<Item>& items, const Item& added) {
    const auto place = std::ranges::lower_bound(items, added.id, {}, &Item::id);
    if (place == items.end() || place->id != added.id)
        items.insert(place, added);
    else
        place->writes = place->writes || added.writes;
}

void Access::merge(const Access& other) {
    for (const Item& component : other.components) add(components, component);
    for (const Item& resource : other.resources) add(resources, resource);
    commands = commands || other.commands;
    reads_world = reads_world || other.reads_world;
    exclusive = exclusive || other.exclusive;
}

bool Access::writes() const { return exclusive || commands || any_written(components) || any_written(resources); }

bool conflicts(const Access& a, const Access& b) {
    if (a.exclusive || b.exclusive || contest_entities(a, b)) return true;
    if ((a.reads_world && b.writes()) || (b.reads_world && a.writes())) return true;
    return clash(a.components, b.components) || clash(a.resources, b.resources);
}

std::vector<std::string_view> contested(const Access& a, const Access& b) {
    if (a.exclusive || b.exclusive) return {"World"};
    std::vector<std::string_view> names;
    if (contest_entities(a, b)) names.push_back("Commands");
    add_clashes(a.components, b.components, names);
    add_clashes(a.resources, b.resources, names);
    for (const auto& [reader, writer] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        if (!reader->reads_world) continue;
        add_written(writer->components, names);
        add_written(writer->resources, names);
    }
    std::ranges::sort(names);
    const auto repeated = std::ranges::unique(names);
    names.erase(repeated.begin(), repeated.end());
    return names;
}

} // namespace hachure
