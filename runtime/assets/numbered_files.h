#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace hachure::assets {

/// The files that are there of a numbered name, `shot.####.exr` as frame_pattern.h has it, as frames of a film: frame 0
/// is the one with the lowest number, and numbers count on from there. One that is missing shows the file before it.
class NumberedFiles {
public:
    /// Lists the folder; looks into no file. Numbers have at most nine digits. Throws Error for a name with more than
    /// one run of '#', and where there is no file of it.
    explicit NumberedFiles(const std::filesystem::path& pattern);

    [[nodiscard]] const std::filesystem::path& pattern() const { return pattern_; }
    [[nodiscard]] std::span<const std::int64_t> numbers() const { return numbers_; } ///< of the files, ascending

    [[nodiscard]] int frame_count() const; ///< from the lowest number to the highest; >= 1
    [[nodiscard]] int missing() const { return frame_count() - static_cast<int>(numbers_.size()); }

    /// The frame that frame `index` in [0, frame_count()) shows: itself, or the last one before that has a file.
    [[nodiscard]] int shown_frame(int index) const;

    /// The file that frame `index` shows.
    [[nodiscard]] std::filesystem::path file(int index) const;

private:
    std::filesystem::path pattern_;
    std::vector<std::int64_t> numbers_;
};

/// Whether a name means numbered files: it has a '#', and there is no file that is called so.
[[nodiscard]] bool is_numbered_name(const std::filesystem::path& path);

} // namespace hachure::assets
