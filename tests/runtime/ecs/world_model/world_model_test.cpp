// The world against a model of it made of std::map, under random operations. HACHURE_ECS_OPERATIONS (default 20000 per
// seed) and HACHURE_ECS_SEED (default: four fixed seeds) widen or repeat the search.

#include <hachure/tests/runtime/ecs/world_model/model_twins.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace hachure::test::model {
namespace {

std::uint64_t from_environment(const char* name, std::uint64_t fallback) {
    const char* text = std::getenv(name);
    return text ? std::strtoull(text, nullptr, 10) : fallback;
}

/// From worlds in which everything collides to worlds of many blocks of storage.
std::size_t entities_for(std::uint64_t seed) {
    constexpr std::size_t most[]{30, 200, 1000, 4000};
    return most[seed % 4];
}

void run(std::uint64_t seed, std::uint64_t operations) {
    Twins twins(seed, entities_for(seed));
    const std::uint64_t whole = std::max<std::uint64_t>(500, operations / 30);
    for (std::uint64_t i = 1; i <= operations; ++i) {
        twins.step();
        if (i % 100 == 0) twins.compare_sample();
        if (i % whole == 0 || i == operations) twins.compare();
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed << ", operation " << i;
    }
}

TEST(WorldModelTest, BehavesAsTheModel) {
    const std::uint64_t operations = from_environment("HACHURE_ECS_OPERATIONS", 20'000);
    const std::uint64_t fixed = from_environment("HACHURE_ECS_SEED", 0);
    for (const std::uint64_t seed : fixed ? std::vector{fixed} : std::vector<std::uint64_t>{1, 2, 3, 4}) {
        run(seed, operations);
        if (testing::Test::HasFailure()) return;
        EXPECT_EQ(Instances::live, 0) << "a world takes its components with it";
        EXPECT_EQ(Instances::faults, 0);
    }
}

} // namespace
} // namespace hachure::test::model
