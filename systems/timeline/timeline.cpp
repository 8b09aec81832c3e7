#include <hachure/components/scene_event.h>
#include <hachure/components/timeline.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/timeline/timeline.h>
#include <hachure/systems/timeline/timeline_actions.h>
#include <hachure/systems/timeline/timeline_part.h>
#include <hachure/systems/timeline/timeline_player.h>

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <vector>

namespace hachure {
namespace {

class TimelineSystem {
public:
    explicit TimelineSystem(const TypeRegistry& types) : types_(&types) {}

    void run(World& world) {
        counts_ = {};
        forget_removed(world);
        collect(world);
        if (targets_.update(world)) forget_targets();
        for (Active& active : active_) advance(world, active);
        resolve(world);
        for (const Active& active : active_)
            if (active.shown && world.alive(active.entity)) active.player->show(world, counts_, warnings_);
        // Where everything is by now.
        for (const Active& active : active_)
            if (active.turns && world.alive(active.entity)) active.player->turn(world, counts_, warnings_);
        active_.clear();
        TimelineCounts& counts = world.resource_mutable<TimelineCounts>();
        counts = counts_;
    }

private:
    struct Active {
        Entity entity;
        TimelinePlayer* player;
        bool shown = false; ///< has moved on
        bool turns = false; ///< plays
    };

    void forget_removed(const World& world) {
        for (const Entity entity : world.removed_since<Timeline>(seen_)) players_.erase(entity);
        seen_ = world.tick() - 1;
    }

    /// The timelines of this frame: what actions add begins in the next one.
    void collect(const World& world) {
        for (auto [entity, timeline] : world.query<const Timeline>()) {
            if (!timeline.document) continue;
            std::unique_ptr<TimelinePlayer>& player = players_[entity];
            if (!player || &player->document() != timeline.document.get())
                player = std::make_unique<TimelinePlayer>(*types_, timeline.document);
            active_.push_back({entity, player.get()});
        }
    }

    void forget_targets() {
        targets_.forget();
        for (auto& [entity, player] : players_) player->resolved = false;
    }

    void advance(World& world, Active& active) {
        const Timeline* timeline = world.find<Timeline>(active.entity);
        if (!timeline) return; // destroyed by an action of one before
        TimelinePlayer& player = *active.player;
        active.shown = player.clock.advance(*timeline, world.resource<Time>().delta);
        active.turns = active.shown || timeline->playing;
        if (active.shown) ++counts_.timelines;
        if (timeline->time != player.clock.time) world.find_mutable<Timeline>(active.entity)->time = player.clock.time;
        for (const animation::PassedEvent& passed : player.clock.passed) {
            do_action({world, targets_, warnings_, active.entity}, player.document().actions[passed.event]);
            ++counts_.actions;
            if (targets_.update(world)) forget_targets();
        }
    }

    void resolve(const World& world) {
        for (const Active& active : active_) {
            if (active.player->resolved || !(active.shown || active.turns) || !world.alive(active.entity)) continue;
            active.player->resolve(world, active.entity, targets_, warnings_);
            counts_.searched += active.player->document().targets.size();
        }
    }

    const TypeRegistry* types_;
    TimelineTargets targets_;
    WarnOnce warnings_;
    std::unordered_map<Entity, std::unique_ptr<TimelinePlayer>> players_;
    std::vector<Active> active_;
    TimelineCounts counts_;
    Tick seen_ = 0;
};

} // namespace

void register_timeline(App& app) {
    app.add_component<Timeline>();
    app.schedule().add_event<SceneEvent>();
    World& world = app.world();
    world.set_resource(TimelineCounts{});
    add_scene_part(world, timeline_part());
    // Scripts see what timelines did in the same frame, and have the last word.
    app.add_system(Stage::script, "timeline",
                   [system = std::make_shared<TimelineSystem>(app.types())](World& all) { system->run(all); })
        .before("script.run");
}

} // namespace hachure
