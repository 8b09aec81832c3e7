#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace hachure::assets {

/// Parses the JSON of a glTF file. Throws hachure::Error about `file`, with the byte offset, for broken syntax, numbers
/// beyond a double, nesting beyond 128 levels (later steps recurse), or more than 500,000 objects or 4,000,000 values
/// (what a file may make the parsers allocate is bounded by this).
[[nodiscard]] nlohmann::json parse_gltf_json(std::string_view text, const std::string& file);

enum class Need { optional, required };

/// A place in the document: checks what stands there and reports faults with its JSON pointer. Each check of a property
/// passes when it is absent and optional. Integers written as 4.0 are accepted and become 4.
class JsonPlace {
public:
    /// The root. `document` and `file` must outlive every place made from it.
    JsonPlace(nlohmann::json& document, const std::string& file) : json_(&document), file_(&file) {}

    [[noreturn]] void fail(std::string_view fault) const;
    [[noreturn]] void fail_at(std::string_view key, std::string_view fault) const;
    [[nodiscard]] std::string pointer() const;

    [[nodiscard]] bool has(std::string_view key) const;
    /// The length of the array at `key`; 0 when there is none.
    [[nodiscard]] std::size_t array_size(std::string_view key) const;

    void string(std::string_view key, Need need = Need::optional) const;
    /// A string that is one of `choices`.
    void choice(std::string_view key, std::initializer_list<std::string_view> choices, Need need) const;
    void strings(std::string_view key) const;
    void boolean(std::string_view key) const;
    /// A number that a float can hold.
    void number(std::string_view key, Need need = Need::optional) const;
    /// An array of such numbers, `count` of them; any number of them when `count` is 0.
    void numbers(std::string_view key, std::size_t count) const;
    /// An integer in [low, high]; returns it, or `absent`.
    std::size_t integer(std::string_view key, std::size_t low, std::size_t high, Need need = Need::optional,
                        std::size_t absent = 0) const;
    /// An index into an array of `count`; returns it, or `count` when absent.
    std::size_t index(std::string_view key, std::size_t count, Need need = Need::optional) const;
    /// An array of such indices.
    void indices(std::string_view key, std::size_t count, Need need = Need::optional) const;
    /// Every member of this object is such an index.
    void index_members(std::size_t count) const;

    using Visit = std::function<void(const JsonPlace&)>;
    /// Visits the object at `key`.
    void object(std::string_view key, const Visit& visit, Need need = Need::optional) const;
    /// Visits each element of the array at `key`; all must be objects.
    void each(std::string_view key, const Visit& visit, Need need = Need::optional) const;
    /// Visits the object at extensions/`name`.
    void extension(std::string_view name, const Visit& visit) const;

private:
    JsonPlace(nlohmann::json& json, const JsonPlace& parent, std::string_view key, std::size_t element)
        : json_(&json), file_(parent.file_), parent_(&parent), key_(key), element_(element) {}

    nlohmann::json* find(std::string_view key, Need need) const;
    nlohmann::json* find_array(std::string_view key, Need need) const;
    nlohmann::json* find_object(std::string_view key, Need need) const;
    std::size_t checked_integer(nlohmann::json& value, std::string_view key, std::size_t low, std::size_t high) const;

    nlohmann::json* json_;
    const std::string* file_;
    const JsonPlace* parent_ = nullptr; // places live on the stack of the check, children inside their parents
    std::string_view key_;              // empty for an element of an array
    std::size_t element_ = 0;
};

} // namespace hachure::assets
