#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::assets {

/// Collects what was repaired or skipped: one line per kind, however often it happens.
class GltfWarnings {
public:
    static constexpr std::size_t max_lines = 100; ///< after these, one line says that there are more

    /// Notes `text` unless it was noted before. Control characters become '?' and the line is cut at 200 bytes, for a
    /// name of the file may be in it; where in the file belongs in `place`, which is told for the first of a kind only.
    void add(std::string_view text, std::string_view place = {});

    [[nodiscard]] std::vector<std::string> take() { return std::move(lines_); }

private:
    std::vector<std::string> kinds_; // sorted
    std::vector<std::string> lines_;
};

} // namespace hachure::assets
