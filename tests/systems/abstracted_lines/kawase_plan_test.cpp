#include <hachure/systems/abstracted_lines/kawase_plan.h>

#include <gtest/gtest.h>

namespace hachure {
namespace {

TEST(KawasePlan, HasTheVariance) {
    for (double deviation = 1.1; deviation < 40.0; deviation *= 1.07) {
        const KawasePlan plan = kawase_plan(deviation);
        EXPECT_NEAR(plan.variance / (deviation * deviation), 1.0, 0.02) << deviation;
        EXPECT_GE(plan.offset, 0.5);
        EXPECT_LE(plan.offset, 2.0);
    }
}

TEST(KawasePlan, GoesDownALevelPerDoubling) {
    EXPECT_EQ(kawase_plan(2.0).levels + 2, kawase_plan(8.0).levels);
    EXPECT_EQ(kawase_plan(4.0).levels + 2, kawase_plan(16.0).levels);
}

} // namespace
} // namespace hachure
