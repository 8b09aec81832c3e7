#include "gltf_builder.h"

#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/error.h>

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace hachure::gltf_testing {
namespace {

void append_u32(Bytes& bytes, std::size_t value) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<unsigned char>(value >> (8 * i) & 0xff));
}

void append_chunk(Bytes& bytes, std::size_t type, std::span<const unsigned char> data, unsigned char padding) {
    const std::size_t padded = (data.size() + 3) / 4 * 4;
    append_u32(bytes, padded);
    append_u32(bytes, type);
    bytes.insert(bytes.end(), data.begin(), data.end());
    bytes.insert(bytes.end(), padded - data.size(), padding);
}

} // namespace

TempFolder::TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "hachure-gltf-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
}

TempFolder::~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

void write_file(const std::filesystem::path& path, std::span<const unsigned char> bytes) {
    std::ofstream stream(path, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void write_file(const std::filesystem::path& path, const std::string& text) {
    write_file(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

Bytes read_file(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

Bytes glb_bytes(const std::string& text, const Bytes& binary) {
    Bytes chunks;
    append_chunk(chunks, 0x4E4F534A, {reinterpret_cast<const unsigned char*>(text.data()), text.size()}, ' ');
    if (!binary.empty()) append_chunk(chunks, 0x004E4942, binary, 0);
    Bytes file = {'g', 'l', 'T', 'F'};
    append_u32(file, 2);
    append_u32(file, chunks.size() + 12);
    file.insert(file.end(), chunks.begin(), chunks.end());
    return file;
}

int GltfBuilder::view(const Bytes& data, int stride) {
    while (binary.size() % 4 != 0) binary.push_back(0);
    json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", data.size()}};
    if (stride != 0) view["byteStride"] = stride;
    binary.insert(binary.end(), data.begin(), data.end());
    return add("bufferViews", view);
}

int GltfBuilder::accessor(int view, Component component, const std::string& type, std::size_t count,
                          std::size_t offset) {
    json accessor = {{"componentType", static_cast<int>(component)}, {"type", type}, {"count", count}};
    if (view >= 0) accessor["bufferView"] = view;
    if (offset != 0) accessor["byteOffset"] = offset;
    return add("accessors", accessor);
}

int GltfBuilder::floats(const std::vector<float>& values, int width) {
    const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    const std::string type = width == 16 ? "MAT4" : types[width];
    return accessor(view(bytes_of(values)), f32, type, values.size() / static_cast<std::size_t>(width));
}

int GltfBuilder::shorts(const std::vector<std::uint16_t>& values) {
    return accessor(view(bytes_of(values)), u16, "SCALAR", values.size());
}

int GltfBuilder::add(const char* array, json element) {
    root[array].push_back(std::move(element));
    return static_cast<int>(root[array].size()) - 1;
}

int GltfBuilder::mesh(json attributes, int indices, int mode) {
    json primitive = {{"attributes", std::move(attributes)}, {"mode", mode}};
    if (indices >= 0) primitive["indices"] = indices;
    const int index = add("meshes", {{"primitives", json::array({primitive})}});
    add("nodes", {{"mesh", index}});
    return index;
}

int GltfBuilder::triangle_positions() { return floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3); }

Bytes GltfBuilder::glb() const {
    json document = root;
    if (!binary.empty() && !document.contains("buffers"))
        document["buffers"] = json::array({{{"byteLength", binary.size()}}});
    return glb_bytes(document.dump(), binary);
}

std::string GltfBuilder::gltf() const {
    json document = root;
    if (!document.contains("buffers"))
        document["buffers"] = json::array(
            {{{"byteLength", binary.size()}, {"uri", "data:application/octet-stream;base64," + base64(binary)}}});
    return document.dump();
}

assets::Model GltfBuilder::read() const {
    const TempFolder folder;
    write_file(folder / "model.glb", glb());
    return assets::read_gltf(folder / "model.glb");
}

std::string base64(std::span<const unsigned char> bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto at = [&](std::size_t k) { return i + k < bytes.size() ? unsigned{bytes[i + k]} : 0u; };
        const unsigned bits = at(0) << 16 | at(1) << 8 | at(2);
        for (unsigned k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string error_of(std::span<const unsigned char> bytes) {
    const TempFolder folder;
    write_file(folder / "model.glb", bytes);
    try {
        const assets::Model model = assets::read_gltf(folder / "model.glb");
        const std::string fault = broken_promise(model);
        return fault.empty() ? "" : "ACCEPTED BUT " + fault;
    } catch (const Error& error) {
        return error.what();
    }
}

std::string error_of(const GltfBuilder& builder) { return error_of(builder.glb()); }

std::string warnings_of(const assets::Model& model) {
    std::string text;
    for (const std::string& warning : model.warnings) text += warning + "\n";
    return text;
}

} // namespace hachure::gltf_testing
