#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/given_models.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "gltf_builder.h"

// Damaged files are refused or read into a valid Model; under the sanitizers, without a fault of ours on the way.
namespace hachure::assets {
namespace {

using namespace gltf_testing;

/// Reads `bytes`; a model that breaks its promise fails the test. Whether it was accepted.
bool survives(const TempFolder& folder, const Bytes& bytes, const std::string& what) {
    write_file(folder / "damaged.glb", bytes);
    try {
        const Model model = read_gltf(folder / "damaged.glb");
        EXPECT_EQ(broken_promise(model), "") << what;
        return true;
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("damaged.glb"), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return false;
    }
}

Bytes damaged(const Bytes& bytes, std::mt19937& random) {
    Bytes result = bytes;
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    for (std::size_t edits = 1 + below(4); edits-- > 0;) {
        const std::size_t at = below(result.size());
        switch (below(4)) {
        case 0:
            result[at] ^= static_cast<unsigned char>(1u << below(8));
            break;
        case 1:
            result[at] = static_cast<unsigned char>(below(256));
            break;
        case 2:
            result[at] = "0123456789-.e[]{},:\""[below(20)];
            break; // in the JSON: another number, another shape
        default:
            std::fill_n(result.begin() + static_cast<std::ptrdiff_t>(at), std::min<std::size_t>(4, result.size() - at),
                        0xff);
            break;
        }
    }
    return result;
}

/// Damages `seed` until the count or the time is up.
void fuzz(const Bytes& seed, const std::string& name, int count, std::chrono::milliseconds time) {
    const TempFolder folder;
    const auto end = std::chrono::steady_clock::now() + time;
    std::mt19937 random(12345);
    for (int i = 0; i < count && std::chrono::steady_clock::now() < end; ++i)
        (void)survives(folder, damaged(seed, random), name + " #" + std::to_string(i));
    for (std::size_t i = 0; i < 16; ++i) {
        const Bytes cut(seed.begin(), seed.begin() + static_cast<std::ptrdiff_t>(seed.size() * i / 16));
        EXPECT_FALSE(survives(folder, cut, name + " cut")) << name << " cut at " << i << "/16";
    }
}

Bytes small_skinned_file() {
    GltfBuilder builder;
    const int positions = builder.triangle_positions();
    const int joints = builder.accessor(builder.view({0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}), u8, "VEC4", 3);
    const int weights = builder.floats({0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
    builder.mesh({{"POSITION", positions}, {"NORMAL", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}},
                 builder.shorts({0, 1, 2}));
    builder.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", positions}}};
    builder.root["nodes"][0].update({{"skin", 0}, {"children", {1}}});
    builder.add("nodes", {{"children", {2}}});
    builder.add("nodes", json::object());
    builder.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", builder.floats(std::vector<float>(32, 1), 16)}});
    const int times = builder.floats({0, 1}, 1);
    const int sparse = builder.accessor(-1, f32, "VEC3", 2);
    builder.root["accessors"][static_cast<std::size_t>(sparse)]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", builder.view({1})}, {"componentType", 5121}}},
        {"values", {{"bufferView", builder.view(bytes_of(std::vector<float>{1, 2, 3}))}}}};
    builder.add("animations", {{"samplers", {{{"input", times}, {"output", sparse}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}});
    return builder.glb();
}

TEST(GltfFuzz, SurvivesDamageToASmallFile) {
    fuzz(small_skinned_file(), "small", 3000, std::chrono::milliseconds(1500));
}

TEST(GltfFuzz, SurvivesDamageToRealModels) {
    if (test::given_models().empty()) GTEST_SKIP() << test::no_given_models;
    for (const char* name : {"characters/khronos/RiggedSimple.glb", "characters/morph/AnimatedMorphCube.glb",
                             "characters/khronos/BoxAnimated.glb", "broken/meshoptimizer_fuzz.glb",
                             "broken/tinygltf/singleBlendshapeCube_sparse.glb"})
        fuzz(read_file(test::given_models() / name), name, 600, std::chrono::milliseconds(500));
}

} // namespace
} // namespace hachure::assets
