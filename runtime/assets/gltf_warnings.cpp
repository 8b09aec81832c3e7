#include <hachure/runtime/assets/gltf_warnings.h>

#include <algorithm>

namespace hachure::assets {

void GltfWarnings::add(std::string_view text, std::string_view place) {
    if (lines_.size() > max_lines) return;
    const auto known = std::lower_bound(kinds_.begin(), kinds_.end(), text);
    if (known != kinds_.end() && *known == text) return;
    kinds_.emplace(known, text);
    if (lines_.size() == max_lines) {
        lines_.emplace_back("there is more to warn of than this");
        return;
    }

    constexpr std::size_t longest = 200;
    std::string line(text.substr(0, longest));
    if (!place.empty()) line.append(" (first at ").append(place.substr(0, longest)).append(")");
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    lines_.push_back(std::move(line));
}

} // namespace hachure::assets
