#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace hachure::assets {

/// A JSON document with its text, so that a fault can be named by line and column. The place of a value is looked up
/// only when it is asked for: reading costs what parsing costs.
class JsonText {
public:
    /// Largest document that is read, and deepest.
    static constexpr std::size_t max_bytes = std::size_t{1} << 30, max_depth = 512;

    /// `subject` names the document in errors. Throws Error with line and column for what is no JSON, for an object
    /// that has a key twice, for what is nested too deep, and for text that is not UTF-8.
    [[nodiscard]] static JsonText parse(std::string subject, std::string text);

    /// The same for a file. Throws Error also when it can't be read or is larger than `max_bytes`.
    [[nodiscard]] static JsonText read(const std::filesystem::path& file);

    [[nodiscard]] const nlohmann::json& root() const { return root_; }
    [[nodiscard]] const std::string& subject() const { return subject_; }

    /// Where the value of a JSON pointer stands, for people: "line 12, column 5: /entities/3/name". A pointer to what
    /// is not there gives the place of the nearest value around it.
    [[nodiscard]] std::string where(std::string_view pointer) const;

    /// Throws Error(subject, fault, where(pointer)).
    [[noreturn]] void fail(std::string_view pointer, std::string_view fault) const;

private:
    std::string subject_, text_;
    nlohmann::json root_;
};

} // namespace hachure::assets
