#pragma once

#include <hachure/components/name.h>
#include <hachure/components/name_index.h>
#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/scene/load_scene.h>
#include <hachure/systems/scene/save_scene.h>
#include <hachure/tests/support/temp_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>

namespace hachure::test {

/// A component with what files and entities are to scene files.
struct Follow {
    Entity target;
    std::string script;
    float distance = 1.0f;
};
inline void remap_entities(Follow& follow, const EntityMap& copies) { follow.target = copies(follow.target); }
inline void reflect(TypeBuilder<Follow>& type) {
    type.name("follow").doc("follows another entity");
    type.field("target", &Follow::target).doc("whom");
    type.field("script", &Follow::script).doc("how").unit("file");
    type.field("distance", &Follow::distance).doc("how far behind").unit("m").range(0, 100);
}

/// A program of all capabilities with an empty world.
inline std::unique_ptr<App> make_app() {
    auto app = std::make_unique<App>();
    register_capabilities(*app);
    app->add_component<Follow>();
    return app;
}

/// A scene of a folder of its own, which has the models "die.obj" and "lone.obj".
class SceneTest : public testing::Test {
protected:
    SceneTest() {
        write("die.obj", "o die\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
        write("lone.obj", "o lone\nv 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
    }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }

    /// Loads a document of these entities into the app of the test.
    LoadedScene load(const std::string& entities, const std::string& more = "", const SceneOptions& options = {}) {
        return load_text("{\"hachure_scene\": 1" + more + ",\n\"entities\": [" + entities + "]}", options);
    }

    LoadedScene load_text(const std::string& text, const SceneOptions& options = {}) {
        return load_scene(*app_, write("test.scene.json", text), options);
    }

    /// What loading the entities throws, without the folder.
    std::string fault(const std::string& entities, const std::string& more = "") {
        const std::size_t before = app_->world().size();
        try {
            static_cast<void>(load(entities, more));
        } catch (const Error& error) {
            EXPECT_EQ(app_->world().size(), before) << "nothing is left of a scene with a fault";
            return without_folder(error.what());
        }
        return "none";
    }

    std::string without_folder(std::string text) const {
        const std::string folder = folder_.path().string() + "/";
        for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
        return text;
    }

    World& world() { return app_->world(); }

    Entity named(const std::string& path) {
        NameIndex index;
        index.update(world());
        return index.find(world(), path);
    }

    template <class C> const C& get(const std::string& path) { return world().get<C>(named(path)); }
    template <class C> bool has(const std::string& path) { return world().has<C>(named(path)); }

    std::string save() { return save_scene(world(), app_->types(), folder_.path()); }

    TempFolder folder_;
    std::unique_ptr<App> app_ = make_app();
};

/// The reflected components of an entity and of all below it, entities by their names.
inline nlohmann::json described(const World& world, const TypeRegistry& types, Entity entity) {
    nlohmann::json result = nlohmann::json::object();
    for (const TypeInfo& type : types.types()) {
        const void* component = type.find(world, entity);
        if (!component) continue;
        nlohmann::json& fields = result["components"][type.name] = to_json(type, component, JsonFields::all);
        for (const FieldInfo& field : type.fields)
            if (field.kind == FieldKind::entity) {
                const Entity target = std::get<Entity>(field.get(component));
                const Name* name = world.find<Name>(target);
                fields[field.name] = name ? nlohmann::json(name->text) : nlohmann::json();
            }
    }
    for (const Entity child : world.children(entity)) result["children"].push_back(described(world, types, child));
    return result;
}

/// The whole world, by roots in order of their slots.
inline nlohmann::json described(const World& world, const TypeRegistry& types) {
    std::vector<Entity> roots;
    world.query<Without<Parent>>().each([&](Entity entity) { roots.push_back(entity); });
    std::ranges::sort(roots);
    nlohmann::json result = nlohmann::json::array();
    for (const Entity root : roots) result.push_back(described(world, types, root));
    return result;
}

} // namespace hachure::test
