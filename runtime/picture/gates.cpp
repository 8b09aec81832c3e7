#include <hachure/runtime/picture/gates.h>

#include <fmt/format.h>

namespace hachure::picture {
namespace {

void add(std::string& list, const std::string& text) { list += (list.empty() ? "" : "; ") + text; }

} // namespace

std::string exceeded_gates(const PictureDifference& d, const PictureGates& gates) {
    if (!d.finite) return "a value is not finite";
    std::string result;
    if (d.differing_fraction > gates.share)
        add(result, fmt::format("{:.4g} % of the pixels differ by more than {:.4g}/255, allowed are {:.4g} %",
                                100.0 * d.differing_fraction, gates.difference, 100.0 * gates.share));
    if (d.flip_p99 > gates.flip_p99)
        add(result, fmt::format("FLIP p99 {:.4g} exceeds {:.4g}", d.flip_p99, gates.flip_p99));
    if (d.line_distance > gates.lines)
        add(result, fmt::format("lines are {:.4g} px apart, allowed are {:.4g}", d.line_distance, gates.lines));
    return result;
}

std::string describe(const PictureDifference& d, const PictureGates& gates) {
    if (!d.finite) return "a value is not finite";
    return fmt::format("largest difference {:.4g}/255, {:.4g} % of pixels beyond {:.4g}/255, FLIP p99 {:.4g} max "
                       "{:.4g}, lines {:.4g} px apart",
                       d.max_difference, 100.0 * d.differing_fraction, gates.difference, d.flip_p99, d.flip_max,
                       d.line_distance);
}

} // namespace hachure::picture
