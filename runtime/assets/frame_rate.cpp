#include <hachure/runtime/assets/frame_rate.h>

#include <charconv>
#include <numeric>
#include <string>

namespace hachure::assets {
namespace {

constexpr std::size_t max_decimals = 6;
constexpr std::size_t max_digits = 10;

/// Digits only: no sign, no space, no exponent.
std::optional<std::int64_t> parse_digits(std::string_view text) {
    if (text.empty() || text.size() > max_digits || text.find_first_not_of("0123456789") != text.npos) return {};
    std::int64_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

std::optional<FrameRate> make_rate(std::int64_t frames, std::int64_t seconds) {
    if (seconds < 1 || frames < seconds || frames > max_frame_rate * seconds) return {};
    const std::int64_t common = std::gcd(frames, seconds);
    if (frames / common > max_frame_rate * 1'000'000ll) return {};
    return FrameRate{static_cast<int>(frames / common), static_cast<int>(seconds / common)};
}

} // namespace

std::optional<FrameRate> parse_frame_rate(std::string_view text) {
    if (const std::size_t slash = text.find('/'); slash != text.npos) {
        const auto frames = parse_digits(text.substr(0, slash)), seconds = parse_digits(text.substr(slash + 1));
        return frames && seconds ? make_rate(*frames, *seconds) : std::nullopt;
    }
    const std::size_t point = text.find('.');
    if (point == text.npos) {
        const auto frames = parse_digits(text);
        return frames ? make_rate(*frames, 1) : std::nullopt;
    }
    const std::string_view decimals = text.substr(point + 1);
    if (decimals.size() > max_decimals) return {};
    std::int64_t scale = 1;
    for (std::size_t i = 0; i < decimals.size(); ++i) scale *= 10;
    const auto whole = parse_digits(text.substr(0, point)), part = parse_digits(decimals);
    return whole && part ? make_rate(*whole * scale + *part, scale) : std::nullopt;
}

} // namespace hachure::assets
