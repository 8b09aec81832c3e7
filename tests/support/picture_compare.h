#pragma once

#include <hachure/runtime/picture/gates.h>

#include <gtest/gtest.h>

namespace hachure::test {

using picture::compare_pictures;
using picture::PictureDifference;

/// At most 5/255 apart but for .1 % of the pixels, FLIP p99 <= .05, lines within 2 px of each other, all finite.
inline ::testing::AssertionResult same_driver_gate(const assets::Image& a, const assets::Image& b) {
    if (a.width != b.width || a.height != b.height || a.channels < 3 || b.channels < 3)
        return ::testing::AssertionFailure() << "the pictures differ in size or have no colour";
    const PictureDifference d = compare_pictures(a, b);
    const bool alike = picture::exceeded_gates(d, picture::PictureGates{}).empty();
    return (alike ? ::testing::AssertionSuccess() : ::testing::AssertionFailure()) << picture::describe(d);
}

} // namespace hachure::test
