#include <hachure/systems/animation/part_source.h>

#include <fmt/format.h>

#include <charconv>

namespace hachure {

nlohmann::json shortest_number(float number) {
    const std::string text = fmt::format("{}", number);
    double result = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

} // namespace hachure
