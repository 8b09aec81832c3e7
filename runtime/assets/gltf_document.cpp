#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/assets/gltf_check.h>
#include <hachure/runtime/assets/gltf_container.h>
#include <hachure/runtime/assets/gltf_document.h>
#include <hachure/runtime/assets/gltf_extras.h>
#include <hachure/runtime/assets/gltf_json.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

namespace hachure::assets {
namespace {

using nlohmann::json;

std::optional<std::string> optional_string(const json& object, const char* key) {
    const auto it = object.find(key);
    return it != object.end() ? std::optional(it->get<std::string>()) : std::nullopt;
}

// Takes out of the document what tinygltf shall not load.
void take_sources(json& root, GltfDocument& document) {
    for (const json& buffer : root.value("buffers", json::array()))
        document.buffers.push_back({optional_string(buffer, "uri"), buffer.at("byteLength").get<std::size_t>()});
    for (const json& image : root.value("images", json::array()))
        document.images.push_back(
            {image.value("name", std::string()), optional_string(image, "uri"), image.value("bufferView", -1)});
    root.erase("buffers");
    root.erase("images");
}

// Exporters agree on extras/targetNames (glTF 2.0, section 3.7.2.2, implementation note); extras may be anything.
std::vector<std::string> target_names(const json& mesh) {
    std::vector<std::string> names;
    const auto extras = mesh.find("extras");
    if (extras == mesh.end() || !extras->is_object()) return names;
    const auto list = extras->find("targetNames");
    if (list == extras->end() || !list->is_array()) return names;
    for (const json& name : *list) names.push_back(name.is_string() ? name.get<std::string>() : std::string());
    return names;
}

// What each object of the array says to Hachure.
std::vector<std::string> take_extras(const json& root, const char* array, GltfWarnings& warnings) {
    std::vector<std::string> result;
    const auto objects = root.find(array);
    if (objects == root.end()) return result;
    for (const json& object : *objects)
        result.push_back(hachure_extras(object, fmt::format("/{}/{}", array, result.size()), warnings));
    return result;
}

// Drops extras and extensions that the reader does not understand: tinygltf would make of them a tree that takes up to
// a hundred times the bytes of its text.
void drop_what_is_not_read(json& value) {
    if (value.is_object()) {
        value.erase("extras");
        if (const auto extensions = value.find("extensions"); extensions != value.end()) {
            for (auto it = extensions->begin(); extensions->is_object() && it != extensions->end();)
                it = understands_extension(it.key()) ? std::next(it) : extensions->erase(it);
        }
    }
    if (value.is_structured())
        for (json& child : value) drop_what_is_not_read(child);
}

// Nor are the bounds that accessors state: a third of the JSON of a file of many clips, all of it untrusted.
void drop_stated_bounds(json& root) {
    if (!root.contains("accessors")) return;
    for (json& accessor : root.at("accessors"))
        for (const char* key : {"min", "max", "name"}) accessor.erase(key);
}

// tinygltf drops animation channels without a target node, which pointer channels are.
void give_every_channel_a_node(json& root) {
    if (!root.contains("animations")) return;
    for (json& animation : root.at("animations")) {
        if (!animation.contains("channels")) continue;
        for (json& channel : animation.at("channels")) {
            json& target = channel.at("target");
            if (!target.contains("node")) target["node"] = -1;
        }
    }
}

// tinygltf refuses index accessors without a buffer view, which are all sparse: an empty view at the end stands for it.
void give_every_index_accessor_a_view(json& root, std::size_t absent_view) {
    if (!root.contains("meshes")) return;
    bool used = false;
    for (const json& mesh : root.at("meshes")) {
        for (const json& primitive : mesh.at("primitives")) {
            if (!primitive.contains("indices")) continue;
            json& accessor = root.at("accessors").at(primitive.at("indices").get<std::size_t>());
            if (accessor.contains("bufferView")) continue;
            accessor["bufferView"] = absent_view;
            used = true;
        }
    }
    if (used) root["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 0}});
}

std::string first_line(const std::string& text) { return text.substr(0, std::min(text.find('\n'), std::size_t{200})); }

void convert(json root, GltfDocument& document) {
    const std::string text = root.dump();
    root = nullptr; // tinygltf is about to build its own tree
    tinygltf::TinyGLTF loader;
    std::string error, warning;
    if (!loader.LoadASCIIFromString(document.model.get(), &error, &warning, text.data(),
                                    static_cast<unsigned int>(text.size()), "", tinygltf::NO_REQUIRE))
        document.fail("is not glTF 2.0: " + first_line(error));
}

} // namespace

GltfDocument::GltfDocument() : model(std::make_unique<tinygltf::Model>()) {}
GltfDocument::GltfDocument(GltfDocument&&) noexcept = default;
GltfDocument::~GltfDocument() = default;

void GltfDocument::fail(std::string_view fault, std::string_view where) const { throw Error(file, fault, where); }

GltfDocument open_gltf(const std::filesystem::path& path, GltfWarnings& warnings) {
    GltfDocument document;
    document.path = path;
    document.file = path.string();
    document.bytes = read_file_bytes(path);
    const GltfChunks chunks = split_gltf(document.bytes, document.file, warnings);
    document.binary = chunks.binary;

    json root = parse_gltf_json(chunks.json, document.file);
    check_gltf(root, document.file);
    take_sources(root, document);
    if (root.contains("meshes"))
        for (const json& mesh : root.at("meshes")) document.target_names.push_back(target_names(mesh));
    document.node_extras = take_extras(root, "nodes", warnings);
    document.material_extras = take_extras(root, "materials", warnings);
    document.scene_extras = take_extras(root, "scenes", warnings);
    drop_what_is_not_read(root);
    drop_stated_bounds(root);
    give_every_channel_a_node(root);
    if (root.contains("bufferViews")) document.buffer_view_count = root.at("bufferViews").size();
    give_every_index_accessor_a_view(root, document.buffer_view_count);
    convert(std::move(root), document);
    return document;
}

} // namespace hachure::assets
