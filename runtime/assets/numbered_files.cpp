#include <hachure/runtime/assets/frame_pattern.h>
#include <hachure/runtime/assets/numbered_files.h>
#include <hachure/runtime/error.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

namespace hachure::assets {
namespace {

constexpr std::int64_t highest_number = 999'999'999;

/// The number for which `pattern` names the file; none when no number does.
std::optional<std::int64_t> number_of(const std::filesystem::path& pattern, const std::string& name) {
    const std::string wanted = pattern.filename().string();
    const std::size_t start = wanted.find('#'), after = wanted.size() - wanted.find_last_of('#') - 1;
    if (name.size() <= start + after) return {};
    const std::string digits = name.substr(start, name.size() - after - start);
    if (digits.find_first_not_of("0123456789") != digits.npos) return {};
    std::int64_t number = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (fault != std::errc{} || number > highest_number) return {};
    return frame_file(pattern, number).filename() == name ? std::optional(number) : std::nullopt;
}

} // namespace

NumberedFiles::NumberedFiles(const std::filesystem::path& pattern) : pattern_(pattern) {
    if (count_number_fields(pattern) != 1)
        throw Error(pattern.string(), "names numbered files, but not with one run of # in its name");
    const std::filesystem::path folder = pattern.parent_path().empty() ? "." : pattern.parent_path();
    std::error_code fault;
    for (std::filesystem::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault))
        if (const auto number = number_of(pattern, entry->path().filename().string())) numbers_.push_back(*number);
    if (fault) throw Error(pattern.string(), "has a folder that can't be listed", fault.message());
    if (numbers_.empty())
        throw Error(pattern.string(),
                    "names no file that is there, such as " + frame_file(pattern, 1).filename().string());
    std::ranges::sort(numbers_);
}

int NumberedFiles::frame_count() const { return static_cast<int>(numbers_.back() - numbers_.front() + 1); }

int NumberedFiles::shown_frame(int index) const {
    const auto after = std::ranges::upper_bound(numbers_, numbers_.front() + index);
    return static_cast<int>(*(after - 1) - numbers_.front());
}

std::filesystem::path NumberedFiles::file(int index) const {
    return frame_file(pattern_, numbers_.front() + shown_frame(index));
}

bool is_numbered_name(const std::filesystem::path& path) {
    std::error_code ignored;
    return count_number_fields(path) > 0 && !std::filesystem::is_regular_file(path, ignored);
}

} // namespace hachure::assets
