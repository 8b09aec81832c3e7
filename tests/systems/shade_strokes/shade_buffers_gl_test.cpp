#include <hachure/systems/shade_strokes/shade_buffers.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/shade_rig.h>

#include <gtest/gtest.h>

#include <cstring>
#include <span>
#include <vector>

namespace hachure::test {
namespace {

template <class T> bool holds(const gpu::Buffer& buffer, const SlotArray<T>& values) {
    std::vector<T> copy(values.all().begin(), values.all().end());
    std::memset(static_cast<void*>(copy.data()), 0xff, copy.size() * sizeof(T));
    buffer.read(std::span<T>(copy));
    return std::memcmp(copy.data(), values.all().data(), copy.size() * sizeof(T)) == 0;
}

bool holds_all(const ShadeBuffers& buffers, const ShadeChains& chains) {
    std::vector<float> delivered(chains.cells.size(), -1.0f);
    buffers.delivered.read(std::span<float>(delivered));
    for (std::size_t c = 0; c < delivered.size(); ++c)
        if (delivered[c] != chains.cells[c].delivered) return false;
    return holds(buffers.nodes, chains.nodes) && holds(buffers.segments, chains.segments);
}

using ShadeBuffersTest = GlTest;

TEST_P(ShadeBuffersTest, PatchesWhatChangedAlone) {
    ShadeRig rig(geometry::icosphere(1.0, 4), 2000);
    ShadeBuffers buffers;
    rig.step_sun(0.0);
    buffers.update(*rig.update.chains);
    const ShadeUploads whole = buffers.uploads();
    EXPECT_TRUE(holds_all(buffers, rig.chains()));
    EXPECT_GE(whole.bytes, rig.chains().segments.all().size_bytes() + rig.chains().nodes.all().size_bytes());

    rig.step_sun(1.0); // a little shade comes and goes
    buffers.update(*rig.update.chains);
    const std::uint64_t patched = buffers.uploads().bytes - whole.bytes;
    EXPECT_TRUE(holds_all(buffers, rig.chains()));
    EXPECT_GT(patched, 0u);
    EXPECT_LT(patched, whole.bytes / 2);

    for (int degrees = 20; degrees <= 180; degrees += 20) { // buffers grow on the way
        rig.step_sun(degrees);
        buffers.update(*rig.update.chains);
        EXPECT_TRUE(holds_all(buffers, rig.chains())) << degrees;
    }
}

TEST_P(ShadeBuffersTest, TouchesNothingWhenNothingMoved) {
    ShadeRig rig(geometry::icosphere(1.0, 3), 1000);
    ShadeBuffers buffers;
    rig.step_sun(30.0);
    buffers.update(*rig.update.chains);
    const ShadeUploads before = buffers.uploads();
    for (int i = 0; i < 3; ++i) {
        rig.step_sun(30.0);
        buffers.update(*rig.update.chains);
    }
    EXPECT_EQ(buffers.uploads(), before);
}

TEST_P(ShadeBuffersTest, CopiesOtherChainsWhole) {
    ShadeRig first(geometry::icosphere(1.0, 3), 1000), second(geometry::icosphere(1.0, 2), 500);
    ShadeBuffers buffers;
    first.step_sun(0.0);
    second.step_sun(90.0);
    ShadeBuffers elsewhere;
    elsewhere.update(*second.update.chains); // its changes are forgotten
    buffers.update(*first.update.chains);
    buffers.update(*second.update.chains);
    EXPECT_TRUE(holds_all(buffers, second.chains()));
}

TEST_P(ShadeBuffersTest, NoStrokesNoBytes) {
    ShadeChains none;
    ShadeBuffers buffers;
    buffers.update(none);
    EXPECT_EQ(buffers.segment_count(), 0u);
    EXPECT_EQ(buffers.uploads().bytes, 0u);
}

HACHURE_INSTANTIATE_GL_TESTS(ShadeBuffersTest);

} // namespace
} // namespace hachure::test
