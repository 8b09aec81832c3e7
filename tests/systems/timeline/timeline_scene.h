#pragma once

#include <hachure/components/name.h>
#include <hachure/components/scene_event.h>
#include <hachure/components/timeline.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/ecs/events.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/timeline/timeline.h>
#include <hachure/systems/transform/transform.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hachure::test {

/// A world with timelines, and what happened in it.
struct TimelineScene {
    TimelineScene() {
        app.add_component<Name>();
        register_transform(app);
        register_timeline(app);
        app.add_system(Stage::animate, "listener", [this](EventReader<SceneEvent> events) {
            for (const SceneEvent& event : events) {
                heard.push_back(event.name);
                about.push_back(event.entity);
            }
        });
    }

    World& world() { return app.world(); }

    Entity add(const char* name, Entity parent = Entity::null) {
        const Entity entity = world().create_with(Name{name}, Transform{});
        if (parent) world().set_parent(entity, parent);
        return entity;
    }

    /// Reads a timeline as a scene file has it.
    Entity play(Entity entity, const std::string& text, const std::filesystem::path& folder = {}) {
        const assets::JsonText document = assets::JsonText::parse("test.scene.json", text);
        part().read(world(), entity, {document, "", document.root(), app.types(), folder, warnings});
        return entity;
    }
    Entity play(const std::string& text) { return play(world().create(), text); }

    const ScenePart& part() { return *world().resource<SceneParts>().find("timeline"); }
    Timeline& timeline(Entity entity) { return world().get_mutable<Timeline>(entity); }
    const Transform& place(Entity entity) { return world().get<Transform>(entity); }
    const TimelineCounts& counts() { return world().resource<TimelineCounts>(); }
    void run(double delta, int frames = 1) {
        for (int i = 0; i < frames; ++i) app.run_frame(delta);
    }

    App app;
    std::vector<std::string> heard, warnings;
    std::vector<Entity> about;
};

} // namespace hachure::test
