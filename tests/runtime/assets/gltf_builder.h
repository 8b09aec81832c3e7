#pragma once

#include <hachure/runtime/assets/model.h>

#include <nlohmann/json.hpp>

#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Small glTF files made in memory, well-formed or broken on purpose.
namespace hachure::gltf_testing {

using nlohmann::json;

enum Component : int { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

/// A folder that is removed with everything in it.
class TempFolder {
public:
    TempFolder();
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

using Bytes = std::vector<unsigned char>;

template <class T> Bytes bytes_of(const std::vector<T>& values) {
    Bytes bytes(values.size() * sizeof(T));
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

void write_file(const std::filesystem::path& path, std::span<const unsigned char> bytes);
void write_file(const std::filesystem::path& path, const std::string& text);
Bytes read_file(const std::filesystem::path& path);

/// A GLB of these chunks.
Bytes glb_bytes(const std::string& text, const Bytes& binary);

/// A document with one buffer; `root` may be edited freely before it is written.
class GltfBuilder {
public:
    json root = {{"asset", {{"version", "2.0"}}}};
    Bytes binary;

    /// Appends `data` at a multiple of 4 and returns the index of its view.
    int view(const Bytes& data, int stride = 0);
    /// An accessor of `count` elements; `type` is "VEC3" and so on. Without a view when `view` is negative.
    int accessor(int view, Component component, const std::string& type, std::size_t count, std::size_t offset = 0);
    /// A view and an accessor of floats, `width` of them per element.
    int floats(const std::vector<float>& values, int width);
    int shorts(const std::vector<std::uint16_t>& values);
    /// Appends to an array of the document and returns the index.
    int add(const char* array, json element);
    /// A mesh of one primitive and a node that draws it; returns the mesh.
    int mesh(json attributes, int indices = -1, int mode = 4);
    /// Three positions, in counter-clockwise order seen from +Z.
    int triangle_positions();

    /// The document as a GLB, or as .gltf with its buffer as a data URI.
    [[nodiscard]] Bytes glb() const;
    [[nodiscard]] std::string gltf() const;
    /// Writes the GLB to a folder of its own and reads it with read_gltf.
    [[nodiscard]] assets::Model read() const;
};

std::string base64(std::span<const unsigned char> bytes);

/// The error message of reading these bytes as a file; empty when they are read without one.
std::string error_of(std::span<const unsigned char> bytes);
std::string error_of(const GltfBuilder& builder);

/// Every warning of the model in one text.
std::string warnings_of(const assets::Model& model);

/// The first sentence of model.h's promise that does not hold; empty when all do.
std::string broken_promise(const assets::Model& model);

} // namespace hachure::gltf_testing
