#pragma once

#include <hachure/tests/benchmarks/abstracted_lines_meter.h>

#include <string>
#include <vector>

namespace hachure::bench {

/// A choice of the knobs of finding lines: what it costs, and how far off it is.
struct Choice {
    std::string name;
    double ms = 0.0;    ///< tone image, blur and lines, by megapixel
    double place = 0.0; ///< LineMeter::place
    double drawn = 0.0; ///< RMS, px, of bars that the renderer draws

    /// Cheaper by more than noise, and by no measure worse.
    [[nodiscard]] bool beats(const Choice& other) const {
        constexpr double noise = 0.07;
        return ms < (1.0 - noise) * other.ms && place <= other.place && drawn <= other.drawn;
    }
};

/// The presets.
[[nodiscard]] std::vector<Finding> presets();

/// Each kind of taps with each number of fits, and the standard with each other kind of blur and of storage.
[[nodiscard]] std::vector<Finding> knobs();

/// Measures all of those with each number of samples, and the presets, which come first.
[[nodiscard]] std::vector<Choice> measured_choices(LineMeter& meter);

} // namespace hachure::bench
