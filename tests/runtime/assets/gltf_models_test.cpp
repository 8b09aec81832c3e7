#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/given_models.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "gltf_builder.h"

// Real files, from the folder that HACHURE_MODELS names; its MANIFEST.md has the counts.
namespace hachure::assets {
namespace {

using namespace gltf_testing;
namespace fs = std::filesystem;

class GltfModels : public testing::Test {
protected:
    void SetUp() override {
        if (test::given_models().empty()) GTEST_SKIP() << test::no_given_models;
        folder_ = test::given_models();
    }

    fs::path folder_;
};

struct Counts {
    const char* file;
    std::size_t triangles, skins, joints, clips, morph_targets;
};

Counts count(const Model& model) {
    Counts counts{};
    for (const Mesh& mesh : model.meshes)
        for (const Primitive& p : mesh.primitives) {
            counts.triangles += p.indices.size() / 3;
            counts.morph_targets = std::max(counts.morph_targets, p.morph_targets.size());
        }
    for (const Skin& skin : model.skins) counts.joints = std::max(counts.joints, skin.joints.size());
    counts.skins = model.skins.size();
    counts.clips = model.animations.size();
    return counts;
}

TEST_F(GltfModels, HaveTheCountsOfTheManifest) {
    const Counts manifest[] = {
        {"characters/khronos/CesiumMan.glb", 4672, 1, 19, 1, 0},
        {"characters/khronos/Fox.glb", 576, 1, 24, 3, 0},
        {"characters/khronos/RecursiveSkeletons.glb", 76, 84, 10, 1, 0},
        {"characters/khronos/InterpolationTest.glb", 110, 0, 0, 9, 0},
        {"characters/khronos/SimpleSkin.gltf", 8, 1, 2, 1, 0},
        {"characters/morph/MorphStressTest.glb", 2412, 0, 0, 3, 8},
        {"characters/morph/MorphPrimitivesTest.glb", 32, 0, 0, 0, 1},
        {"characters/morph/AnimatedMorphSphere.glb", 960, 0, 0, 1, 2},
        {"characters/kaykit/Knight.glb", 6952, 1, 41, 76, 0},
        {"characters/kaykit_manny/Med_MovementBasic.glb", 0, 1, 23, 11, 0},
        {"characters/quaternius/Ninja.gltf", 5964, 1, 43, 14, 0},
        {"characters/cge_knight/knight.gltf", 646, 1, 50, 5, 0},
        {"mechanical/ToyCar/ToyCar.gltf", 108936, 0, 0, 0, 0},
        {"mechanical/CesiumMilkTruck.glb", 2856, 0, 0, 1, 0},
        {"mechanical/cge_gears/gears.gltf", 2304, 1, 4, 1, 0},
        {"meshes/DragonAttenuation.glb", 134995, 0, 0, 0, 0},
        {"broken/CesiumMan_weights_not_normalized.glb", 4672, 1, 19, 1, 0},
    };
    for (const Counts& expected : manifest) {
        SCOPED_TRACE(expected.file);
        const Counts found = count(read_gltf(folder_ / expected.file));
        EXPECT_EQ(found.triangles, expected.triangles);
        EXPECT_EQ(found.skins, expected.skins);
        EXPECT_EQ(found.joints, expected.joints);
        EXPECT_EQ(found.clips, expected.clips);
        EXPECT_EQ(found.morph_targets, expected.morph_targets);
    }
}

TEST_F(GltfModels, AreAllReadAndValid) {
    for (const char* below : {"characters", "mechanical", "meshes"}) {
        for (const fs::path& file : test::given_gltf_files(below)) {
            SCOPED_TRACE(file.string());
            const Model model = read_gltf(file);
            EXPECT_EQ(broken_promise(model), "");
            for (const std::string& warning : model.warnings)
                EXPECT_TRUE(warning.starts_with("the extension KHR_materials_")) << warning;
        }
    }
}

TEST_F(GltfModels, FoxHasNoNormals) {
    const Model fox = read_gltf(folder_ / "characters/khronos/Fox.glb");
    EXPECT_TRUE(fox.meshes.at(0).primitives.at(0).normals.empty());
    EXPECT_EQ(fox.images.size(), 1u);
}

TEST_F(GltfModels, BrokenFilesAreRefusedOrReadIntoValidModels) {
    std::size_t refused = 0, read = 0;
    for (const fs::path& file : test::given_gltf_files("broken")) {
        SCOPED_TRACE(file.string());
        try {
            EXPECT_EQ(broken_promise(read_gltf(file)), "");
            ++read;
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 100u);
    EXPECT_GT(read, 100u);
}

TEST_F(GltfModels, PositiveCasesOfTheAssetGeneratorAreRead) {
    for (const fs::path& file : test::given_gltf_files("broken/asset-generator/Positive")) {
        SCOPED_TRACE(file.string());
        // Two of them are there to be refused by a reader of glTF 2.0.
        const std::string name = file.stem().string();
        if (name == "Compatibility_04" || name == "Compatibility_05")
            EXPECT_THROW((void)read_gltf(file), Error);
        else
            EXPECT_EQ(broken_promise(read_gltf(file)), "");
    }
}

} // namespace
} // namespace hachure::assets
