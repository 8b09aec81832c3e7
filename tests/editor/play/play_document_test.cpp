#include <hachure/editor/play/play_document.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/capabilities.h>
#include <hachure/tests/support/mutations.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

namespace hachure::test {
namespace {

const TypeRegistry& types() {
    static App app;
    static const bool registered = (register_capabilities(app), true);
    static_cast<void>(registered);
    return app.types();
}

/// Every key that there is.
const std::string whole = R"({
  "hachure_play": 1, "doc": "all of it", "scene": "x.glb", "style": "gooch", "set": ["gooch.b=0.5", "Fox/gooch.y=1"],
  "fps": "30000/1001", "size": [320, 240], "seed": 7, "frames": 60, "backend": "osmesa", "clip": "Run",
  "input": [{"frame": 3, "key_down": "space"}, {"frame": 5, "pointer_move": [10, 20.5]}, {"frame": 3, "key_up": "space"},
            {"frame": 5, "button_down": "left"}, {"frame": 6, "button_up": "left"}, {"frame": 7, "scroll": [0, -1]}],
  "expect": [
    {"frame": 10, "picture": "golden/x.png", "mask": "m.png",
     "gates": {"difference": 5, "share": 0.001, "flip_p99": 0.05, "lines": 2}},
    {"frame": 10, "aov": "depth", "picture": "golden/d.exr", "gates": {"difference": 0.1, "share": 0}},
    {"frame": 10, "aov": "color"},
    {"frame": 10, "field": "Fox/transform.translation", "is": [0, 0, 1], "tolerance": 1e-5},
    {"frames": [0, 10], "field": "Fox/transform.translation.y", "at_least": 0, "at_most": 2},
    {"frame": 1, "field": "camera.projection", "is": "perspective"},
    {"frame": 5, "count": "surface", "is": 3},
    {"frame": 5, "count": "triangles_drawn", "at_most": 1000},
    {"frame": 5, "pass": "gooch", "state": "reused"},
    {"frame": 5, "passes": ["gooch"]},
    {"frames": [3, 20], "allocations": 0},
    {"frames": [0, 50], "popping": {"at_most": 8, "p999_at_most": 4, "reach": 2}},
    {"frames": [0, 50], "flicker": {"at_most": 0.01, "mean_at_most": 0.005, "largest_at_most": 0.2, "reach": 3}},
    {"time": {"of": "load", "relative_to": {"set": ["deform.device=gpu"]}, "at_most": 1.5}}
  ]
})";

play::PlayDocument parse(std::string text) { return play::parse_play(types(), "folder/t.play.json", std::move(text)); }

/// The fault that is found when `from` became `to`.
std::string fault(const std::string& from, const std::string& to) {
    std::string text = whole;
    const std::size_t at = text.find(from);
    if (at == text.npos) return "the test has no " + from;
    text.replace(at, from.size(), to);
    try {
        static_cast<void>(parse(text));
        return "none";
    } catch (const Error& error) {
        return error.what();
    }
}

void expect_fault(const std::string& from, const std::string& to, const std::string& words, const std::string& where) {
    const std::string what = fault(from, to);
    EXPECT_TRUE(what.starts_with("folder/t.play.json: ")) << what;
    EXPECT_NE(what.find(words), what.npos) << what;
    EXPECT_NE(what.find(where), what.npos) << what;
    EXPECT_NE(what.find("line "), what.npos) << what;
}

TEST(PlayDocument, ReadsEveryKey) {
    const play::PlayDocument test = parse(whole);
    EXPECT_EQ(test.folder, "folder");
    EXPECT_EQ(test.doc, "all of it");
    EXPECT_EQ(test.scene, "folder/x.glb");
    EXPECT_EQ(test.style, "gooch");
    EXPECT_EQ(test.sets, (std::vector<std::string>{"gooch.b=0.5", "Fox/gooch.y=1"}));
    EXPECT_EQ(test.fps, (assets::FrameRate{30000, 1001}));
    EXPECT_EQ(test.size, (Canvas{320, 240}));
    EXPECT_EQ(test.seed, 7u);
    EXPECT_EQ(test.frames, 60);
    EXPECT_EQ(test.backend, gpu::Backend::osmesa);
    EXPECT_EQ(test.clip, "Run");
    ASSERT_EQ(test.input.at(3).size(), 2u);
    EXPECT_EQ(test.input.at(3)[1], (InputEvent{InputKind::key_up, "space", {}}));
    EXPECT_EQ(test.input.at(5)[0], (InputEvent{InputKind::pointer_move, "", {10.0f, 20.5f}}));
    EXPECT_EQ(test.expectations.size(), 14u);
    EXPECT_EQ(test.expectations[4]->frames().last, 10);
    EXPECT_EQ(test.expectations[10]->kind(), "allocations");
}

TEST(PlayDocument, FaultsSayLineColumnAndWhat) {
    EXPECT_NE(fault("\"seed\": 7", "\"sed\": 7").find("line 3, column"), std::string::npos)
        << fault("\"seed\": 7", "\"sed\": 7");
    expect_fault("\"seed\": 7", "\"sed\": 7", "'sed' is unknown", "/sed");
    expect_fault("\"hachure_play\": 1", "\"hachure_play\": 2", "hachure_play", "/hachure_play");
    expect_fault("\"scene\": \"x.glb\"", "\"doc2\": \"\"", "'scene' is missing", "line 1");
    expect_fault("gooch.b=0.5", "gooch.b=7", "gooch.b", "/set/0");
    expect_fault("gooch.b=0.5", "gouache.b=7", "gouache", "/set/0");
    expect_fault("\"30000/1001\"", "0", "fps", "/fps");
    expect_fault("[320, 240]", "[320, -1]", "size", "/size");
    expect_fault("[320, 240]", "[320, 2.5]", "size", "/size");
    expect_fault("\"seed\": 7", "\"seed\": -1", "seed", "/seed");
    expect_fault("\"frames\": 60", "\"frames\": 0", "frames", "/frames");
    expect_fault("\"frames\": 60", "\"frames\": 1e9", "frames", "/frames");
    expect_fault("osmesa", "vulkan", "backend", "/backend");
    expect_fault("\"frame\": 3", "\"frame\": 60", "the last frame is 59", "/input");
    expect_fault("\"key_down\": \"space\"", "\"key\": \"space\"", "an event is one of", "/input/0");
    expect_fault("[10, 20.5]", "[10]", "pointer_move", "/input/1/pointer_move");
}

TEST(PlayDocument, FaultsOfExpectations) {
    expect_fault("\"frame\": 10", "\"frame\": 60", "from 0 to 59", "/expect/0/frame");
    expect_fault("\"frame\": 10, \"picture\"", "\"picture\"", "either frame or frames", "/expect/0");
    expect_fault("\"frames\": [0, 10]", "\"frames\": [10, 0]", "frames is no", "/expect/4/frames");
    expect_fault("\"frames\": [0, 10]", "\"frames\": [0, 60]", "frames is no", "/expect/4/frames");
    expect_fault("\"picture\": \"golden/x.png\"", "\"pictur\": \"golden/x.png\"", "says nothing that can be expected",
                 "/expect/0");
    expect_fault("golden/x.png", "../x.png", "below the test's folder", "/expect/0/picture");
    expect_fault("golden/x.png", "/x.png", "below the test's folder", "/expect/0/picture");
    expect_fault("golden/x.png", "golden/x.jpg", "no .png file", "/expect/0/picture");
    expect_fault("\"share\": 0.001", "\"share\": 2", "share is no number from 0 to 1", "/expect/0/gates/share");
    expect_fault("\"lines\": 2", "\"line\": 2", "'line' is unknown", "/expect/0/gates/line");
    expect_fault("\"difference\": 5", "\"difference\": null", "difference", "/expect/0/gates/difference");
    expect_fault("Fox/transform.translation\"", "Fox/transform.translate\"", "no field 'translate'", "/expect/3/field");
    expect_fault("translation.y", "translation.r", "no element 'r'", "/expect/4/field");
    expect_fault("[0, 0, 1]", "[0, 0]", "transform.translation", "/expect/3/is");
    expect_fault("\"at_least\": 0, \"at_most\": 2", "\"at_least\": 3, \"at_most\": 2", "more than at_most",
                 "/expect/4/at_least");
    expect_fault(", \"at_least\": 0, \"at_most\": 2", "", "either is, or", "/expect/4");
    expect_fault("\"count\": \"surface\"", "\"count\": \"surfaces\"", "neither a component nor", "/expect/6/count");
    expect_fault("\"is\": 3", "\"is\": 2.5", "whole number", "/expect/6/is");
    expect_fault("\"reused\"", "\"skipped\"", "none of run, reused, culled, absent", "/expect/8/state");
    expect_fault("\"allocations\": 0", "\"allocations\": -1", "allocations", "/expect/10/allocations");
    expect_fault("\"frames\": [0, 50], \"popping\"", "\"frame\": 0, \"popping\"", "between frames", "/expect/11");
    expect_fault("{\"at_most\": 8, \"p999_at_most\": 4, \"reach\": 2}", "{}", "popping takes", "/expect/11/popping");
    expect_fault("\"frames\": [0, 50], \"flicker\"", "\"frames\": [0, 1], \"flicker\"", "three frames",
                 "/expect/12/frames");
    expect_fault("\"of\": \"load\"", "\"of\": \"lunch\"", "neither frame nor load", "/expect/13/time/of");
    expect_fault("deform.device=gpu", "deform.device=abacus", "abacus", "/expect/13/time/relative_to/set/0");
}

TEST(PlayDocument, CollectsAllFaults) {
    const TempFolder folder;
    const std::filesystem::path file = folder.write("t.play.json", R"({"hachure_play": 1, "scene": "", "fps": 0, "x": 1,
        "expect": [{"frame": 9, "picture": "a.png"}, {"frame": 0, "count": "fish", "is": 1}]})");
    const std::vector<std::string> faults = play::play_faults(types(), file);
    ASSERT_EQ(faults.size(), 5u);
    for (const char* pointer : {"/scene", "/fps", "/x", "/expect/0/frame", "/expect/1/count"})
        EXPECT_TRUE(std::ranges::any_of(faults, [&](const auto& f) { return f.find(pointer) != f.npos; })) << pointer;
    EXPECT_EQ(play::play_faults(types(), folder.write("u.play.json", whole)).size(), 0u);
    EXPECT_EQ(play::play_faults(types(), folder.write("v.play.json", "{")).size(), 1u);
    EXPECT_EQ(play::play_faults(types(), folder / "missing.play.json").size(), 1u);
}

TEST(PlayDocument, ARecordingComesBackAsItWas) {
    const TempFolder folder;
    const play::InputByFrame input = parse(whole).input;
    play::write_recording(folder / "r.input.json", input);
    EXPECT_EQ(play::read_recording(folder / "r.input.json"), input);
    const auto file = folder.write("t.play.json", R"({"hachure_play": 1, "scene": "x.glb", "frames": 4,
        "recording": "r.input.json", "expect": [{"frame": 0, "count": "name", "is": 0}]})");
    EXPECT_EQ(play::read_play(types(), file).input, input) << "what comes after the last frame is never played";
    folder.write("r.input.json", R"({"hachure_input": 1, "events": [{"frame": 1}]})");
    EXPECT_THROW(static_cast<void>(play::read_play(types(), file)), Error);
}

/// Bytes of the document are changed, removed and doubled: it is read or refused in words, whatever comes of it.
TEST(PlayDocument, SurvivesMutations) {
    std::mt19937 random(20261122);
    const std::string bytes = "\"{}[]:,0129-.eE \\tnul/ax\n\xff";
    int refused = 0;
    for (int i = 0, count = mutation_count(); i < count; ++i) {
        std::string text = whole;
        for (unsigned edits = 1 + random() % 4; edits-- > 0;) {
            const std::size_t at = random() % text.size(), length = 1 + random() % 12;
            switch (random() % 4) {
            case 0:
                text[at] = bytes[random() % bytes.size()];
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(random() % text.size(), length));
                break;
            default:
                text.insert(at, 1, bytes[random() % bytes.size()]);
            }
        }
        try {
            static_cast<void>(parse(text));
        } catch (const Error& error) {
            ++refused;
            EXPECT_TRUE(std::string(error.what()).starts_with("folder/t.play.json: ")) << error.what();
        }
    }
    EXPECT_GT(refused, mutation_count() / 2);
}

} // namespace
} // namespace hachure::test
