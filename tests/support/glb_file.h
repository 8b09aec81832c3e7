#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace hachure::test {
namespace glb_detail {

template <class T> std::string bytes(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

inline std::string u32(std::size_t value) { return glb_detail::bytes(std::vector{static_cast<std::uint32_t>(value)}); }

} // namespace glb_detail

/// A GLB of a JSON chunk and a binary chunk.
inline std::string glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const std::size_t total = 12 + 8 + json.size() + 8 + binary.size();
    return "glTF" + glb_detail::u32(2) + glb_detail::u32(total) + glb_detail::u32(json.size()) + "JSON" + json +
           glb_detail::u32(binary.size()) + std::string("BIN\0", 4) + binary;
}

/// Two squares in z = 0 that face +Z, as nodes "left" (x in [-2, 0]) and "right" (x in [0, 2]), y in [-1, 1]; seen by
/// an orthographic camera whose picture they fill when it is twice as wide as high.
inline std::string two_squares_glb() {
    const std::string positions = glb_detail::bytes(std::vector<float>{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
    const std::string indices = glb_detail::bytes(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3});
    return glb(R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 60}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "cameras": [{"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 1, "znear": 0.1, "zfar": 10}}],
        "nodes": [{"name": "left", "mesh": 0, "translation": [-1, 0, 0]},
                  {"name": "right", "mesh": 0, "translation": [1, 0, 0]},
                  {"name": "eye", "camera": 0, "translation": [0, 0, 5]}],
        "scenes": [{"nodes": [0, 1, 2]}], "scene": 0})",
               positions + indices);
}

/// The first of them alone, which a clip of one second moves from left to right before the same camera.
inline std::string moving_square_glb() {
    const std::string positions = glb_detail::bytes(std::vector<float>{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
    const std::string indices = glb_detail::bytes(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3});
    const std::string keys = glb_detail::bytes(std::vector<float>{0, 1, -1, 0, 0, 1, 0.1f, 0});
    return glb(R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 92}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12},
                        {"buffer": 0, "byteOffset": 60, "byteLength": 8}, {"buffer": 0, "byteOffset": 68, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
                      {"bufferView": 2, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
                      {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "cameras": [{"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 1, "znear": 0.1, "zfar": 10}}],
        "animations": [{"name": "slide", "samplers": [{"input": 2, "output": 3}],
                        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
        "nodes": [{"name": "square", "mesh": 0}, {"name": "eye", "camera": 0, "translation": [0, 0, 5]}],
        "scenes": [{"nodes": [0, 1]}], "scene": 0})",
               positions + indices + keys);
}

/// The JSON of a triangle.
inline std::string triangle_json() {
    return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 44}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "nodes": [{"mesh": 0}, {"name": "spare"}], "scenes": [{"nodes": [0]}], "scene": 0})";
}

/// Its binary chunk: three positions of floats, three indices of 16 bits.
inline std::string triangle_binary() {
    return glb_detail::bytes(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}) +
           glb_detail::bytes(std::vector<std::uint16_t>{0, 1, 2, 0});
}

/// The triangle with its JSON edited: `from` became `to`.
inline std::string edited_triangle_glb(const std::string& from, const std::string& to) {
    std::string json = triangle_json();
    const std::size_t at = json.find(from);
    if (at == std::string::npos) throw std::logic_error("the triangle has no " + from);
    return glb(json.replace(at, from.size(), to), triangle_binary());
}

} // namespace hachure::test
