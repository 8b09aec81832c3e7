#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/editor/play/played.h>
#include <hachure/tests/support/glb_file.h>

#include <algorithm>
#include <random>

// Faults that are planted, each of which its expectation has to find.
namespace hachure::test {
namespace {

using nlohmann::json;
using Planted = Played;

json looks(json gates = json::object()) {
    return {{"frame", 1}, {"picture", "golden.png"}, {"gates", std::move(gates)}};
}

/// Of a picture whose other gates are open.
json only_lines(double pixels) { return {{"share", 1}, {"flip_p99", 1}, {"lines", pixels}}; }

assets::Image golden_of(const TempFolder& folder) { return assets::read_image(folder / "golden.png"); }

void keep(const TempFolder& folder, const assets::Image& image) { assets::write_png(folder / "golden.png", image); }

bool is_dark(const assets::Image& image, int x, int y) {
    const std::uint8_t* p = image.u8() + image.channels * (y * image.width + x);
    return std::max({p[0], p[1], p[2]}) < 110;
}

/// The picture moved right by a pixel.
assets::Image moved(const assets::Image& image) {
    assets::Image result = image;
    const int c = image.channels;
    for (int y = 0; y < image.height; ++y)
        std::copy_n(image.u8() + c * y * image.width, c * (image.width - 1), result.u8() + c * (y * image.width + 1));
    return result;
}

TEST_F(Planted, AMissingGoldenSaysHowToMakeIt) {
    EXPECT_NE(failure(play(still_test(looks()))).find("--update"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "golden.png"));
    const play::PlayResult made = play(still_test(looks()), {.update = true});
    EXPECT_EQ(failure(made), "");
    EXPECT_TRUE(made.expectations.at(0).renewed);
    EXPECT_EQ(failure(play(still_test(looks()))), "");
    EXPECT_FALSE(play(still_test(looks()), {.update = true}).expectations.at(0).renewed) << "it was the same";
}

TEST_F(Planted, ALostLine) {
    play(still_test(looks()), {.update = true});
    assets::Image image = golden_of(folder_);
    const int c = image.channels;
    // The box's lines stand in the upper right; there each dark pixel becomes what is left of the line.
    int lost = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 64; x < 90; ++x)
            if (is_dark(image, x, y)) {
                std::copy_n(image.u8() + c * (y * image.width + x - 1), c, image.u8() + c * (y * image.width + x));
                ++lost;
            }
    ASSERT_GT(lost, 10);
    keep(folder_, image);
    EXPECT_NE(failure(play(still_test(looks(only_lines(2))))).find("lines are"), std::string::npos);
    EXPECT_NE(failure(play(still_test(looks()))), "");
}

TEST_F(Planted, ALineThatMovedByAPixel) {
    play(still_test(looks()), {.update = true});
    keep(folder_, moved(golden_of(folder_)));
    EXPECT_NE(failure(play(still_test(looks(only_lines(0.5))))).find("lines are 1 px apart"), std::string::npos);
    EXPECT_EQ(failure(play(still_test(looks(only_lines(2))))), "") << "which the default lets pass";
}

TEST_F(Planted, NoiseOfOneStepIsNoFault) {
    play(still_test(looks()), {.update = true});
    assets::Image image = golden_of(folder_);
    std::mt19937 random(11);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.u8()[i] = static_cast<std::uint8_t>(std::clamp(image.u8()[i] + int(random() % 3) - 1, 0, 255));
    keep(folder_, image);
    const play::PlayResult noisy = play(still_test(looks()));
    EXPECT_EQ(failure(noisy), "");
    EXPECT_NEAR(noisy.expectations.at(0).picture->max_difference, 1.0, 1e-9);
}

TEST_F(Planted, AMaskHidesAFault) {
    play(still_test(looks()), {.update = true});
    assets::Image image = golden_of(folder_), mask = image;
    std::fill_n(mask.u8(), mask.pixels.size(), std::uint8_t{255});
    for (int y = 10; y < 30; ++y)
        for (int i = 0; i < 20 * image.channels; ++i) {
            image.u8()[image.channels * (y * image.width + 10) + i] ^= 0x80;
            mask.u8()[image.channels * (y * image.width + 10) + i] = 0;
        }
    keep(folder_, image);
    assets::write_png(folder_ / "mask.png", mask);
    EXPECT_NE(failure(play(still_test(looks()))), "");
    json expectation = looks();
    expectation["mask"] = "mask.png";
    EXPECT_EQ(failure(play(still_test(expectation))), "");
}

TEST_F(Planted, AGoldenOfAnotherSizeAndOneThatIsBroken) {
    keep(folder_, assets::make_image(64, 48, 3, assets::PixelType::u8));
    EXPECT_NE(failure(play(still_test(looks()))).find("64x48"), std::string::npos);
    folder_.write("golden.png", "no picture");
    EXPECT_NE(failure(play(still_test(looks()))), "");
}

TEST_F(Planted, AWrongField) {
    const auto field = [](const char* path, json is) {
        return still_test({{"frames", {0, 3}}, {"field", path}, {"is", std::move(is)}});
    };
    EXPECT_EQ(failure(play(field("ring/transform.translation", {0.9, 0.22, 1.1}))), "");
    EXPECT_NE(failure(play(field("ring/transform.translation", {0.9, 0.23, 1.1})))
                  .find("frame 0: it is 0.9 0.22 1.1 (and 3 more)"),
              std::string::npos);
    EXPECT_EQ(failure(play(field("gooch.y", 0.4))), "") << "all surfaces";
    EXPECT_NE(failure(play(field("gooch.y", 0.5))), "");
    EXPECT_NE(failure(play(field("nobody/gooch.y", 0.4))).find("nobody"), std::string::npos);
    EXPECT_NE(failure(play(still_test({{"frame", 0}, {"count", "surface"}, {"is", 5}}))).find("there are 4, not 5"),
              std::string::npos);
}

TEST_F(Planted, AnExtraPass) {
    const auto passes = [](json names) { return still_test({{"frame", 0}, {"passes", std::move(names)}}); };
    EXPECT_EQ(failure(play(passes({"targets", "gooch", "edge_lines", "overlay"}))), "");
    EXPECT_NE(failure(play(passes({"targets", "gooch"}))).find("these run, too: edge_lines, overlay"),
              std::string::npos);
    EXPECT_NE(failure(play(passes({"targets", "gooch", "edge_lines", "overlay", "metal"}))).find("do not run: metal"),
              std::string::npos);
    const auto state = [](const char* pass, const char* name) {
        return still_test({{"frame", 2}, {"pass", pass}, {"state", name}});
    };
    EXPECT_EQ(failure(play(state("gooch", "reused"))), "") << "though nothing else looks at the frame before";
    EXPECT_NE(failure(play(state("gooch", "run"))), "");
    EXPECT_EQ(failure(play(state("depth", "absent"))), "");
}

/// Two squares, the right one away for one frame of six when it `pops`.
std::string popping_glb(bool pops) {
    using glb_detail::bytes;
    const float away = pops ? 50.0f : 1.0f;
    const std::string binary = bytes(std::vector<float>{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}) +
                               bytes(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}) +
                               bytes(std::vector<float>{0, 0.09f, 0.12f, 1, 0, 0, away, 0, 0, 1, 0, 0});
    return glb(R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 108}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12},
                        {"buffer": 0, "byteOffset": 60, "byteLength": 12}, {"buffer": 0, "byteOffset": 72, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
                      {"bufferView": 2, "componentType": 5126, "count": 3, "type": "SCALAR", "min": [0], "max": [0.12]},
                      {"bufferView": 3, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "cameras": [{"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2, "znear": 0.1, "zfar": 10}}],
        "nodes": [{"name": "left", "mesh": 0, "translation": [-1, 0, 0]}, {"name": "right", "mesh": 0, "translation": [1, 0, 0]},
                  {"name": "eye", "camera": 0, "translation": [0, 0, 5]}],
        "animations": [{"samplers": [{"input": 2, "output": 3, "interpolation": "STEP"}],
                        "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}]}],
        "scenes": [{"nodes": [0, 1, 2]}], "scene": 0})",
               binary);
}

TEST_F(Planted, AStrokeThatPops) {
    const auto test = [&](bool pops, json expectation) {
        folder_.write("squares.glb", popping_glb(pops));
        return failure(play({{"hachure_play", 1},
                             {"scene", "squares.glb"},
                             {"fps", 30},
                             {"size", {96, 64}},
                             {"frames", 6},
                             {"set", {"animation.repeat=once"}},
                             {"expect", json::array({std::move(expectation)})}}));
    };
    const json popping{{"frames", {0, 5}}, {"popping", {{"at_most", 8}}}};
    EXPECT_EQ(test(false, popping), "");
    EXPECT_NE(test(true, popping).find("frame 3: a pixel changes by"), std::string::npos) << test(true, popping);
    const json flicker{{"frames", {0, 5}}, {"flicker", {{"at_most", 0.01}}}};
    EXPECT_EQ(test(false, flicker), "");
    EXPECT_NE(test(true, flicker).find("flicker p99"), std::string::npos);
}

TEST_F(Planted, ABufferThatDiffers) {
    const json depth{{"frame", 0}, {"aov", "depth"}, {"picture", "depth.exr"}};
    EXPECT_EQ(failure(play(still_test(depth), {.update = true})), "");
    EXPECT_EQ(failure(play(still_test(depth))), "");
    const auto edit = [&](int count, float change) {
        assets::Image image = assets::read_image(folder_ / "depth.exr");
        for (int i = 0; i < count; ++i) image.f32()[image.width * 60 + 30 + i] += change;
        assets::write_exr(folder_ / "depth.exr", image, std::vector<std::string>{"Z"});
    };
    edit(40, 0.01f);
    EXPECT_NE(failure(play(still_test(depth))).find("% of pixels beyond 0.001"), std::string::npos);
    edit(1, std::numeric_limits<float>::quiet_NaN());
    EXPECT_NE(failure(play(still_test(depth))).find("not finite"), std::string::npos);
}

/// Renewing pictures mends pictures and nothing else.
TEST_F(Planted, UpdateHidesNoOtherFault) {
    json test = still_test(looks());
    test["expect"].push_back({{"frame", 0}, {"count", "surface"}, {"is", 5}});
    const play::PlayResult result = play(test, {.update = true});
    EXPECT_TRUE(result.expectations.at(0).renewed);
    EXPECT_FALSE(result.passed);
    EXPECT_NE(failure(result).find("there are 4, not 5"), std::string::npos);
    std::filesystem::remove(folder_ / "golden.png");
    test["set"] = {"nobody/gooch.b=1"};
    EXPECT_FALSE(play(test, {.update = true}).passed);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "golden.png")) << "of a run that went wrong nothing is kept";
}

TEST_F(Planted, ALongTimeIsOne) {
    const auto time = [](double at_most) {
        return still_test(
            {{"time", {{"of", "frame"}, {"relative_to", {{"set", {"gooch.b=0.5"}}}}, {"at_most", at_most}}}});
    };
    EXPECT_EQ(failure(play(time(1000))), "");
    EXPECT_NE(failure(play(time(1e-6))).find("times"), std::string::npos);
}

} // namespace
} // namespace hachure::test
