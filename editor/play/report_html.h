#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// What every part of the report writes with. Whatever comes from a file goes through `html_text`.
namespace hachure::play {

/// Text for elements and quoted attributes alike: markup is escaped, bytes that are no UTF-8 and control characters but
/// tab and newline become U+FFFD.
[[nodiscard]] std::string html_text(std::string_view text);

/// The same of a path.
[[nodiscard]] std::string html_path(const std::filesystem::path& path);

/// At most four digits, "∞" and "n/a" for what is no number.
[[nodiscard]] std::string html_number(double value);

/// "0.43 s", "12.4 s", "3 min 20 s".
[[nodiscard]] std::string html_seconds(double seconds);

/// An img element that holds the PNG file itself, with its size, so that nothing moves when it is shown; or a box that
/// says that the picture is missing. `description` is what it shows in words, `classes` those of the element.
[[nodiscard]] std::string html_picture(const std::filesystem::path& png, std::string_view description,
                                       std::string_view classes = {});

} // namespace hachure::play
