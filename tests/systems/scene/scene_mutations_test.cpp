#include <hachure/tests/support/mutations.h>
#include <hachure/tests/systems/scene/scene_fixture.h>

#include <chrono>
#include <random>

namespace hachure::test {
namespace {

/// Everything that a scene can say, with room where a changed byte changes nothing.
constexpr const char* whole = R"({
  "hachure_scene": 1, "doc": "all there is, in one scene, which has a long line of words that say what it shows, as docs do", "style": "gooch", "zork": 1,
  "looks": {"l": {"gooch": {"b": 0.3}, "edge_lines": null}},
  "entities": [
    {"name": "Ship", "transform": {"translation": [1.5, 0, -2], "rotation": [0, 0.6, 0, 0.8], "scale": [1, 2, 3]},
     "children": [{"name": "Mast", "gooch": {"b": 0.1}}, {"light": {"color": "#ff8800", "kind": "point"}}]},
    {"model": "die.obj", "look": "l"},
    {"name": "B", "model": "die.obj", "overrides": {"die": {"surface": {"tint": [0.5, 0.25, 1], "visible": true}}},
     "children": [{"name": "Hat", "below": "die", "follow": {"target": "Ship", "script": "t.lua"}}]},
    {"name": "In", "scene": "inner.scene.json", "look": "l"},
    {"name": "Eye", "camera": {"yfov": 0.7}, "animation": {"clip": "Run", "time": 2}}
  ]
})";

constexpr const char* draft = R"({"hachure_scene": 0, "objects": [{"id": "A", "file": "die.obj"},
  {"id": "B", "parent": "A", "position": [0, 1, 0], "components": {"gooch": {}}}]})";

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

void flip_bytes(std::string& text, Random& random) {
    for (std::size_t n = 1 + below(random, 8); n > 0; --n)
        text[below(random, text.size())] = static_cast<char>(random());
}

void cut(std::string& text, Random& random) { text.resize(below(random, text.size())); }

void lose(std::string& text, Random& random) { text.erase(below(random, text.size()), 1 + below(random, 30)); }

/// Puts a piece of the text elsewhere in it: keys that are there twice, lists in lists.
void repeat(std::string& text, Random& random) {
    const std::string piece = text.substr(below(random, text.size()), 1 + below(random, 200));
    text.insert(below(random, text.size()), piece);
}

void change_number(std::string& text, Random& random) {
    constexpr const char* numbers[] = {"1e308",
                                       "-1e308",
                                       "1e-400",
                                       "99999999999999999999999",
                                       "-9223372036854775808",
                                       "0.1e39",
                                       "1",
                                       "0.5",
                                       "0",
                                       "3",
                                       "-0.0",
                                       "NaN",
                                       "4294967296",
                                       "1e400"};
    const std::size_t digit = text.find_first_of("0123456789", below(random, text.size()));
    if (digit != std::string::npos) text.replace(digit, 1, numbers[below(random, std::size(numbers))]);
}

/// Puts values of other kinds, and nesting, in the place of a value.
void change_value(std::string& text, Random& random) {
    const std::string deep(below(random, 2000), '[');
    const std::string values[] = {"null",    "true", "[]",      "{}", "\"\"",     "\"\\u0000\"",
                                  "[[[1]]]", deep,   "\"../\"", "-1", "\"Ship\"", "{\"scene\": \"test.scene.json\"}"};
    const std::size_t colon = text.find(':', below(random, text.size()));
    if (colon == std::string::npos) return;
    const std::size_t end = text.find_first_of(",}]", colon);
    text.replace(colon + 1, end == std::string::npos ? 0 : end - colon - 1, values[below(random, std::size(values))]);
}

/// Swaps two words: keys of other places, values of other fields.
void swap_words(std::string& text, Random& random) {
    const auto word = [&](std::size_t from) {
        const std::size_t begin = text.find('"', from);
        const std::size_t end = begin == text.npos ? text.npos : text.find('"', begin + 1);
        return end == text.npos ? std::string("\"\"") : text.substr(begin, end + 1 - begin);
    };
    const std::string one = word(below(random, text.size())), other = word(below(random, text.size()));
    if (const std::size_t at = text.find(one); at != text.npos) text.replace(at, one.size(), other);
}

std::string mutated(std::uint64_t seed) {
    Random random(seed);
    std::string text = below(random, 5) == 0 ? draft : whole;
    constexpr void (*mutations[])(std::string&, Random&) = {flip_bytes,    cut,          lose,      repeat,
                                                            change_number, change_value, swap_words};
    for (std::size_t n = 1 + below(random, 3); n > 0 && !text.empty(); --n)
        mutations[below(random, std::size(mutations))](text, random);
    return text;
}

class SceneMutations : public SceneTest {
protected:
    /// What was loaded can be saved, loaded and saved again, and stays the same.
    void expect_same_again(const App& app, int seed) {
        try {
            const std::string text = save_scene(app.world(), app.types(), folder_.path());
            const auto again = make_app();
            static_cast<void>(load_scene(*again, write("again.scene.json", text)));
            EXPECT_EQ(save_scene(again->world(), again->types(), folder_.path()), text) << "seed " << seed;
            EXPECT_EQ(described(again->world(), again->types()), described(app.world(), app.types()))
                << "seed " << seed;
        } catch (const Error& error) {
            ADD_FAILURE() << "seed " << seed << ": " << error.what();
        }
    }
};

// HACHURE_MUTATIONS=10000 searches longer; a failure names the seed.
TEST_F(SceneMutations, WhateverAFileHoldsItIsASceneOrAnError) {
    write("inner.scene.json", R"({"hachure_scene": 1, "entities": [{"name": "Arm", "model": "die.obj"}]})");
    static_cast<void>(load_text(whole));
    const int count = mutation_count();
    int scenes = 0, errors = 0;
    const auto app = make_app();
    for (int seed = 1; seed <= count; ++seed) {
        const std::filesystem::path file = write("test.scene.json", mutated(static_cast<std::uint64_t>(seed)));
        const auto begin = std::chrono::steady_clock::now();
        const std::size_t before = app->world().size();
        try {
            const LoadedScene scene = load_scene(*app, file);
            if (seed % 4 == 0) expect_same_again(*app, seed);
            app->world().destroy_many(scene.roots);
            ++scenes;
        } catch (const Error&) {
            ++errors;
        }
        ASSERT_EQ(app->world().size(), before) << "seed " << seed;
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        ASSERT_LT(seconds.count(), 5.0) << "seed " << seed;
    }
    EXPECT_GE(scenes, count / 20) << "mutations that nothing survives show little";
    EXPECT_GE(errors, count / 4);
}

TEST_F(SceneMutations, InspectionOfWhateverAFileHoldsEnds) {
    write("inner.scene.json", R"({"hachure_scene": 1, "entities": [{"name": "Arm", "model": "die.obj"}]})");
    const int count = mutation_count() / 4;
    for (int seed = 1; seed <= count; ++seed) {
        const std::filesystem::path file = write("test.scene.json", mutated(static_cast<std::uint64_t>(seed)));
        bool fine = true;
        try {
            const auto app = make_app();
            static_cast<void>(load_scene(*app, file));
            expect_same_again(*app, seed);
        } catch (const Error&) {
            fine = false;
        }
        EXPECT_EQ(inspect_scene(*make_app(), file).faults.empty(), fine) << "seed " << seed;
    }
}

} // namespace
} // namespace hachure::test
