#include <hachure/runtime/assets/gltf_extras.h>
#include <hachure/runtime/assets/gltf_json.h>
#include <hachure/runtime/error.h>

#include <nlohmann/json.hpp>

#include <string_view>

namespace hachure::assets {
namespace {

using nlohmann::json;

constexpr std::string_view own_key = "hachure";

/// Gathers what the keys of one object say.
class ExtrasReader {
public:
    ExtrasReader(const std::string& where, GltfWarnings& warnings) : where_(where), warnings_(warnings) {}

    /// `path` is empty, "component" or "component.field".
    void put(std::string_view path, const json& written) {
        const json value = parsed(written);
        if (value.is_null() || value.is_discarded()) return;
        if (path.empty()) return put_all(value);
        const std::size_t dot = path.find('.');
        const std::string name(path.substr(0, dot));
        if (dot == path.npos) return put_component(name, value);
        if (json& fields = result_[name]; !fields.is_object()) fields = json::object();
        result_[name][std::string(path.substr(dot + 1))] = value;
    }

    [[nodiscard]] std::string text() const { return result_.empty() ? std::string() : result_.dump(); }

private:
    void put_all(const json& value) {
        if (!value.is_object()) return warn("is no object of components");
        for (const auto& [path, member] : value.items()) put(path, member);
    }

    void put_component(const std::string& name, const json& value) {
        const bool absent = value == json(false) || (value.is_number() && value == json(0));
        json& component = result_[name];
        if (absent)
            result_.erase(name);
        else if (value.is_boolean() || value.is_number())
            component = component.is_object() ? component : json::object();
        else if (value.is_object() && component.is_object())
            component.update(value);
        else
            component = value;
    }

    /// The value that a text with JSON in it means; discarded when it is broken.
    json parsed(const json& value) {
        const std::string* text = value.get_ptr<const std::string*>();
        if (!text || text->find_first_not_of(" \t\r\n") == text->npos ||
            (*text)[text->find_first_not_of(" \t\r\n")] != '{')
            return value;
        try {
            return parse_gltf_json(*text, where_);
        } catch (const Error&) {
            warn("has a text that is not valid JSON");
            return json(json::value_t::discarded);
        }
    }

    void warn(std::string_view fault) { warnings_.add("extras.hachure " + std::string(fault), where_ + "/extras"); }

    const std::string& where_;
    GltfWarnings& warnings_;
    json result_ = json::object();
};

/// What follows "hachure" in a key of ours: empty, or ".gooch.b" and the like.
bool is_ours(std::string_view key) {
    return key.starts_with(own_key) && (key.size() == own_key.size() || key[own_key.size()] == '.');
}

} // namespace

std::string hachure_extras(const json& object, const std::string& where, GltfWarnings& warnings) {
    const auto extras = object.find("extras");
    if (extras == object.end() || !extras->is_object()) return {};
    ExtrasReader reader(where, warnings);
    for (const auto& [key, value] : extras->items()) // in the order of their names, the shorter ones first
        if (is_ours(key)) reader.put(std::string_view(key).substr(std::min(key.size(), own_key.size() + 1)), value);
    std::string text = reader.text();
    if (text.size() <= max_extras_bytes) return text;
    warnings.add("extras.hachure that are longer than 1 MiB are skipped", where);
    return {};
}

} // namespace hachure::assets
