#pragma once

#include <hachure/runtime/assets/json_text.h>

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::play {

/// The members of a JSON object, each read once and checked; what nobody read is unknown and a fault. All members throw
/// Error with line and column.
class JsonObject {
public:
    /// Throws when the value is no object. `text` and `value` must outlive it.
    JsonObject(const assets::JsonText& text, std::string pointer, const nlohmann::json& value);

    [[nodiscard]] bool has(std::string_view key) const { return value_->contains(key); }

    /// The member; null when it is not there.
    const nlohmann::json* find(const std::string& key);

    /// The member, which has to be there.
    const nlohmann::json& at(const std::string& key);

    std::string text(const std::string& key);                       ///< a string that is not empty
    std::string text(const std::string& key, std::string fallback); ///< the same, or `fallback`
    double number(const std::string& key, double min, double max);  ///< finite, in [min, max]
    double number(const std::string& key, double min, double max, double fallback);
    std::int64_t integer(const std::string& key, std::int64_t min, std::int64_t max);
    std::int64_t integer(const std::string& key, std::int64_t min, std::int64_t max, std::int64_t fallback);
    std::vector<std::string> texts(const std::string& key); ///< an array of strings; none when absent

    /// Faults the members that nobody asked for.
    void finish() const;

    /// The pointer of a member, whether or not it is there.
    [[nodiscard]] std::string pointer(std::string_view key) const;
    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] const assets::JsonText& document() const { return *text_; }

    /// Throws Error about that member.
    [[noreturn]] void fail(std::string_view key, std::string_view fault) const { text_->fail(pointer(key), fault); }

private:
    const assets::JsonText* text_;
    std::string pointer_;
    const nlohmann::json* value_;
    std::set<std::string, std::less<>> known_;
};

/// `pointer` with one more step.
[[nodiscard]] std::string child_pointer(std::string_view pointer, std::string_view key);
[[nodiscard]] std::string child_pointer(std::string_view pointer, std::size_t index);

} // namespace hachure::play
