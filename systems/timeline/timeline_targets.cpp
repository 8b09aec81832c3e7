#include <hachure/components/name.h>
#include <hachure/systems/timeline/timeline_targets.h>

#include <algorithm>

namespace hachure {

bool TimelineTargets::update(const World& world) {
    const bool news = world.last_changed<Name>() > seen_ || world.last_changed<Parent>() > seen_;
    if (!news) return false;
    index_.update(world);
    const bool matters = names_matter(world) || tree_matters(world);
    seen_ = world.tick() - 1; // more may happen in the current tick
    return matters;
}

bool TimelineTargets::named_as_a_target(const World& world, Entity entity) const {
    const Name* name = world.find<Name>(entity);
    return name && names_.contains(name->text);
}

bool TimelineTargets::names_matter(const World& world) const {
    if (world.last_changed<Name>() <= seen_) return false;
    for (const Entity entity : world.removed_since<Name>(seen_))
        if (entities_.contains(entity)) return true;
    for (auto [entity, name] : world.query<const Name>().changed_since<Name>(seen_))
        if (names_.contains(name.text) || entities_.contains(entity)) return true;
    return false;
}

/// An entity that moves takes along what is below it. Each is looked at once, however many moved above it.
bool TimelineTargets::tree_matters(const World& world) const {
    if (names_.empty() || world.last_changed<Parent>() <= seen_) return false;
    std::unordered_set<Entity> known;
    std::vector<Entity> waiting;
    const auto add = [&](Entity entity) {
        if (known.insert(entity).second) waiting.push_back(entity);
    };
    for (const Entity entity : world.removed_since<Parent>(seen_)) add(entity);
    for (auto [entity, parent] : world.query<const Parent>().changed_since<Parent>(seen_)) add(entity);
    while (!waiting.empty()) {
        const Entity entity = waiting.back();
        waiting.pop_back();
        if (entities_.contains(entity) || named_as_a_target(world, entity)) return true;
        std::ranges::for_each(world.children(entity), add);
    }
    return false;
}

void TimelineTargets::forget() {
    names_.clear();
    entities_.clear();
}

void TimelineTargets::resolve(const World& world, Entity carrier, const TimelineDocument& document,
                              std::vector<Entity>& targets) {
    targets.clear();
    for (const std::string& path : document.targets) {
        targets.push_back(find(world, carrier, path));
        watch(world, path, targets.back());
    }
}

Entity TimelineTargets::find(const World& world, Entity carrier, std::string_view path) const {
    if (path.empty()) return carrier;
    const Entity below = world.children(carrier).empty() ? Entity::null : index_.find_below(world, carrier, path);
    return below ? below : index_.find(world, path);
}

void TimelineTargets::watch(const World& world, std::string_view path, Entity entity) {
    // A name may hold slashes itself: every piece between two of them can be one.
    for (std::size_t begin = 0;; ++begin) {
        for (std::size_t end = path.find('/', begin);; end = path.find('/', end + 1)) {
            names_.emplace(path.substr(begin, end == path.npos ? path.npos : end - begin));
            if (end == path.npos) break;
        }
        begin = path.find('/', begin);
        if (begin == path.npos) break;
    }
    for (auto levels = std::ranges::count(path, '/') + 1; entity && levels > 0; --levels) {
        entities_.insert(entity);
        entity = world.parent(entity);
    }
}

} // namespace hachure
