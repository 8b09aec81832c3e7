#include <hachure/runtime/assets/json_place.h>
#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/assets/text_file.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

namespace hachure::assets {
namespace {

using nlohmann::json;

/// As much of a text from a file as fits in a message; never half a character.
std::string shortened(std::string text, std::size_t size) {
    if (text.size() <= size) return text;
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80) --size;
    return text.substr(0, size) + "...";
}

/// What is wrong, out of the parser's "[id] parse error at line 1, column 2: syntax error while parsing ...".
std::string fault_of(std::string_view message) {
    for (const std::string_view before : {"syntax error ", "] "})
        if (const std::size_t at = message.find(before); at != std::string_view::npos) {
            message.remove_prefix(at + before.size());
            break;
        }
    // The rest of such a message quotes bytes that are no text.
    if (const std::size_t at = message.find("; last read"); message.find("UTF-8") < at && at != std::string_view::npos)
        message = message.substr(0, at);
    return "is no JSON: " + shortened(std::string(message), 200);
}

/// Builds the document, as the library's own builder does, and stops at what it lets pass: keys that are there
/// already, and nesting without end. What it returns is whether to go on.
class Builder {
public:
    explicit Builder(json& root) : root_(&root) {}

    std::string fault;                 ///< why it stopped; empty when it did not
    std::size_t position = 0;          ///< of the fault in the text, where the parser found it
    std::optional<std::string> second; ///< a key that is there already, in the object of `pointer()`

    bool null() { return put(nullptr); }
    bool boolean(bool value) { return put(value); }
    bool number_integer(json::number_integer_t value) { return put(value); }
    bool number_unsigned(json::number_unsigned_t value) { return put(value); }
    bool number_float(json::number_float_t value, const json::string_t&) { return put(value); }
    bool string(json::string_t& value) { return put(std::move(value)); }
    bool binary(json::binary_t&) { return false; }

    bool start_object(std::size_t) { return open(json::object()); }
    bool start_array(std::size_t) { return open(json::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(json::string_t& key) {
        auto& object = open_.back()->get_ref<json::object_t&>();
        // Most files that programs wrote have their keys in order: the end is where the next one belongs.
        const std::size_t before = object.size();
        member_ = &object.try_emplace(object.end(), key)->second;
        if (object.size() != before) return true;
        fault = "has the key '" + shortened(key, 60) + "' twice";
        second = std::move(key);
        return false;
    }

    bool parse_error(std::size_t at, const std::string&, const json::exception& error) {
        position = at == 0 ? 0 : at - 1;
        fault = fault_of(error.what());
        return false;
    }

    /// Of the innermost array or object that is open.
    std::string pointer() const {
        std::string result;
        for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
            if (open_[i]->is_array()) {
                result += fmt::format("/{}", open_[i]->size() - 1);
                continue;
            }
            for (const auto& [key, value] : open_[i]->items())
                if (&value == open_[i + 1]) result += "/" + pointer_token(key);
        }
        return result;
    }

private:
    template <class Value> json* place(Value&& value) {
        if (open_.empty()) return &(*root_ = json(std::forward<Value>(value)));
        if (open_.back()->is_array())
            return &open_.back()->get_ref<json::array_t&>().emplace_back(std::forward<Value>(value));
        return &(*member_ = json(std::forward<Value>(value)));
    }

    template <class Value> bool put(Value&& value) {
        place(std::forward<Value>(value));
        return true;
    }

    bool open(json container) {
        open_.push_back(place(std::move(container)));
        if (open_.size() <= JsonText::max_depth) return true;
        fault = fmt::format("is nested deeper than {} levels", JsonText::max_depth);
        return false;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    json* root_;
    std::vector<json*> open_;
    json* member_ = nullptr; ///< the value of the last key
};

} // namespace

JsonText JsonText::parse(std::string subject, std::string text) {
    JsonText result;
    result.subject_ = std::move(subject);
    result.text_ = std::move(text);
    if (result.text_.size() > max_bytes)
        throw Error(result.subject_, fmt::format("is larger than {} bytes", max_bytes));
    Builder builder(result.root_);
    if (json::sax_parse(result.text_.begin(), result.text_.end(), &builder)) return result;
    std::size_t offset = builder.position;
    if (builder.second)
        offset = offset_of_second_key(result.text_, offset_of(result.text_, builder.pointer()), *builder.second);
    else if (builder.position == 0 && !builder.pointer().empty())
        offset = offset_of(result.text_, builder.pointer());
    throw Error(result.subject_, builder.fault, line_and_column(result.text_, offset));
}

JsonText JsonText::read(const std::filesystem::path& file) {
    return parse(file.string(), read_text_file(file, max_bytes));
}

std::string JsonText::where(std::string_view pointer) const {
    const std::string place = line_and_column(text_, offset_of(text_, pointer));
    return pointer.empty() ? place : place + ": " + shortened(std::string(pointer), 200);
}

void JsonText::fail(std::string_view pointer, std::string_view fault) const {
    throw Error(subject_, fault, where(pointer));
}

} // namespace hachure::assets
