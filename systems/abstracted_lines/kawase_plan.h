#pragma once

namespace hachure {

/// How far down a pyramid a dual Kawase blur (Bjorge 2015) goes, and how far its samples are apart, for a Gaussian's
/// variance. shaders/abstracted_lines/kawase_down.frag and kawase_up.frag are what the variances are of.
struct KawasePlan {
    int levels = 1;        ///< halvings
    double offset = 1.0;   ///< of samples, in texels of the picture that is halved, or half ones of what is doubled
    double variance = 0.0; ///< of the whole blur, square pixels: a mean over the phases of its pyramid
};

/// The plan whose variance is that of `deviation`, pixels, and whose offset is nearest to 1, where the blur is
/// smoothest. Deviations under 1.08 cannot be had: the plan is then that of 1.08.
[[nodiscard]] KawasePlan kawase_plan(double deviation);

} // namespace hachure
