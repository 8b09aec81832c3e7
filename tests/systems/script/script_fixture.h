#pragma once

#include <hachure/components/gooch.h>
#include <hachure/components/name.h>
#include <hachure/components/script.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/systems/script/script.h>
#include <hachure/systems/script/script_errors.h>
#include <hachure/systems/script/script_limits.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace hachure::test {

/// What tests write into from Lua: every kind of field.
struct Probe {
    bool yes = false;
    std::int32_t count = 0;
    std::uint64_t many = 0;
    float size = 0.0f;
    double exact = 0.0;
    glm::vec2 two{0.0f};
    glm::vec3 three{0.0f};
    glm::vec4 four{0.0f};
    glm::quat turn{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 tint{0.5f};
    std::string text;
    enum class Mood { calm, cross } mood = Mood::calm;
    Entity target;
};

inline void reflect(TypeBuilder<Probe>& type) {
    type.name("probe");
    type.field("yes", &Probe::yes);
    type.field("count", &Probe::count).range(-10, 1e9);
    type.field("many", &Probe::many);
    type.field("size", &Probe::size).range(0, 1);
    type.field("exact", &Probe::exact);
    type.field("two", &Probe::two);
    type.field("three", &Probe::three);
    type.field("four", &Probe::four);
    type.field("turn", &Probe::turn);
    type.field("tint", &Probe::tint).color();
    type.field("text", &Probe::text);
    type.field("mood", &Probe::mood).options({"calm", "cross"});
    type.field("target", &Probe::target);
}

/// An app with scripts alone, and files to run.
struct ScriptTest : ::testing::Test {
    ScriptTest() {
        register_script(app);
        app.add_component<Name>();
        app.add_component<Transform>();
        app.add_component<Gooch>();
        app.add_component<Probe>();
    }

    World& world() { return app.world(); }
    const std::vector<ScriptError>& errors() { return world().resource<ScriptErrors>().errors; }

    /// An entity that runs this text; its Probe is where the script leaves what the test looks at.
    Entity add(std::string_view text, std::string name = "Fox", const std::string& file = "fox.lua") {
        // A file is compiled once, so that each text needs its own.
        const std::string below = std::to_string(files++);
        std::filesystem::create_directory(folder / below);
        const std::string path = folder.write(below + '/' + file, text).string();
        return world().create_with(Name{std::move(name)}, Script{.file = path}, Probe{}, Transform{});
    }

    /// The same, after a frame of half a second.
    Entity run(std::string_view text) {
        const Entity entity = add(text);
        app.run_frame(0.5);
        return entity;
    }

    const Probe& probe(Entity entity) { return world().get<Probe>(entity); }

    /// Runs a text that is expected to leave `probe.text`; an error's message otherwise.
    std::string answer(std::string_view text) {
        const Entity entity = run(text);
        return errors().empty() ? probe(entity).text : errors().back().message;
    }

    /// What an expression of Lua reads as.
    std::string value(std::string_view expression) {
        return answer("self.probe.text = tostring(" + std::string(expression) + ")");
    }

    TempFolder folder;
    int files = 0;
    App app;
};

} // namespace hachure::test
