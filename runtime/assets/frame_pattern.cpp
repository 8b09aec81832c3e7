#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/frame_pattern.h>

#include <algorithm>
#include <string>

namespace hachure::assets {

int count_number_fields(const std::filesystem::path& pattern) {
    const std::string name = pattern.filename().string();
    int fields = 0;
    for (std::size_t i = 0; i < name.size(); ++i)
        if (name[i] == '#' && (i == 0 || name[i - 1] != '#')) ++fields;
    return fields;
}

std::filesystem::path frame_file(const std::filesystem::path& pattern, std::int64_t number) {
    HACHURE_ASSERT(number >= 0, "frames are numbered from 0");
    const std::string name = pattern.filename().string(), digits = std::to_string(number);
    std::string result;
    for (std::size_t i = 0; i < name.size();) {
        const std::size_t end = std::min(name.find_first_not_of('#', i), name.size());
        if (end == i) {
            result += name[i++];
            continue;
        }
        result.append(std::max(end - i, digits.size()) - digits.size(), '0').append(digits);
        i = end;
    }
    return pattern.parent_path() / result;
}

} // namespace hachure::assets
