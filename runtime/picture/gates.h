#pragma once

#include <hachure/runtime/picture/compare.h>

#include <string>

namespace hachure::picture {

/// How far apart two pictures may be and still count as alike. The defaults are what one driver may do between two
/// runs.
struct PictureGates {
    double difference = same_driver_step; ///< 255ths that a channel may be off ...
    double share = 0.001;                 ///< ... but for this part of the pixels
    double flip_p99 = 0.05;
    double lines = 2.0; ///< pixels
};

/// What is too far apart, in words, gate by gate: "FLIP p99 0.21 exceeds 0.05; ..."; empty when nothing is.
[[nodiscard]] std::string exceeded_gates(const PictureDifference& difference, const PictureGates& gates);

/// The figures in one line.
[[nodiscard]] std::string describe(const PictureDifference& difference, const PictureGates& gates = {});

} // namespace hachure::picture
