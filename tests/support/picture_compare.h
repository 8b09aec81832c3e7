#pragma once

#include <hachure/runtime/picture/compare.h>

#include <gtest/gtest.h>

namespace hachure::test {

using picture::compare_pictures;
using picture::PictureDifference;

/// At most 5/255 apart but for .1 % of the pixels, FLIP p99 <= .05, lines within 2 px of each other, all finite.
inline ::testing::AssertionResult same_driver_gate(const assets::Image& a, const assets::Image& b) {
    if (a.width != b.width || a.height != b.height || a.channels < 3 || b.channels < 3)
        return ::testing::AssertionFailure() << "the pictures differ in size or have no colour";
    const PictureDifference d = compare_pictures(a, b);
    const bool alike = d.finite && d.differing_fraction <= 0.001 && d.flip_p99 <= 0.05 && d.line_distance <= 2.0;
    return (alike ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
           << "largest difference " << d.max_difference << "/255, " << 100.0 * d.differing_fraction
           << " % of pixels beyond " << picture::same_driver_step << "/255, FLIP p99 " << d.flip_p99 << " max "
           << d.flip_max << ", lines " << d.line_distance << " px apart" << (d.finite ? "" : ", not finite");
}

} // namespace hachure::test
