#include <hachure/systems/scene/scene_text.h>

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace hachure {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t columns = 100;

class Writer {
public:
    void write(const Json& value, std::size_t indent) {
        const bool structured = (value.is_object() || value.is_array()) && !value.empty();
        if (!structured) return scalar(value);
        const std::size_t begin = text.size();
        // The whole document and its lists of entities are laid out, however short.
        if (indent > 1 && one_line(value, line_ + columns - 1)) return;
        text.resize(begin);
        const bool object = value.is_object();
        text += object ? '{' : '[';
        bool first = true;
        for (auto item = value.begin(); item != value.end(); ++item) {
            new_line(indent + 1, !first);
            first = false;
            if (object) key(item.key());
            write(*item, indent + 1);
        }
        new_line(indent, false);
        text += object ? '}' : ']';
    }

    std::string text;

private:
    void new_line(std::size_t indent, bool comma) {
        text += comma ? ",\n" : "\n";
        line_ = text.size();
        text.append(2 * indent, ' ');
    }

    void key(const std::string& name) {
        quoted(name);
        text += ": ";
    }

    /// Writes all in the current line; gives up, with part of it written, where that would pass `end`.
    bool one_line(const Json& value, std::size_t end) {
        if (!value.is_object() && !value.is_array()) {
            scalar(value);
            return text.size() <= end;
        }
        const bool object = value.is_object();
        text += object && !value.empty() ? "{ " : object ? "{" : "[";
        bool first = true;
        for (auto item = value.begin(); item != value.end(); ++item) {
            if (!first) text += ", ";
            first = false;
            if (object) key(item.key());
            if (text.size() > end || !one_line(*item, end)) return false;
        }
        text += object && !value.empty() ? " }" : object ? "}" : "]";
        return text.size() <= end;
    }

    void scalar(const Json& value) {
        if (value.is_string())
            quoted(value.get_ref<const std::string&>());
        else if (value.is_number_float())
            number(value.get<double>());
        else
            text += value.dump();
    }

    void number(double value) {
        // Without its point it would be read as an integer, which has no negative zero.
        if (value == 0.0 && std::signbit(value))
            text += "-0.0";
        else
            fmt::format_to(std::back_inserter(text), "{}", value);
    }

    void quoted(const std::string& content) {
        for (const char c : content)
            if (static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\' ||
                static_cast<unsigned char>(c) >= 0x7f) {
                text += nlohmann::json(content).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
                return;
            }
        text += '"';
        text += content;
        text += '"';
    }

    std::size_t line_ = 0; ///< where the current line begins
};

} // namespace

std::string scene_text(const Json& document) {
    Writer writer;
    writer.write(document, 0);
    return std::move(writer.text) + "\n";
}

} // namespace hachure
