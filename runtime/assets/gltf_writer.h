#pragma once

#include <hachure/runtime/assets/gltf_write_data.h>
#include <hachure/runtime/assets/model.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

/// The steps of write_gltf: each puts one part of the Model into the document.
namespace hachure::assets {

struct GltfWriter {
    const Model& model;
    nlohmann::json root = nlohmann::json::object();
    GltfData data;
    std::set<std::string> extensions; ///< used so far
    std::vector<std::int32_t>
        mesh_places; ///< by mesh of the model: its index in the file, -1 for one without triangles
};

/// Images, textures with their samplers, and materials.
void write_look(GltfWriter& writer);
void write_meshes(GltfWriter& writer);
/// Nodes, skins, cameras, lights and scenes; after write_meshes.
void write_nodes(GltfWriter& writer);
void write_animations(GltfWriter& writer);

/// Puts `extras`, the text of an object or empty, where hachure_extras finds it.
void write_extras(nlohmann::json& object, const std::string& extras);

/// Sets root[array] unless there is nothing in it, which glTF does not allow.
void put_array(GltfWriter& writer, const char* array, nlohmann::json values);

/// A vector or matrix as an array of numbers.
template <class V> nlohmann::json gltf_numbers(const V& vector) {
    const auto* numbers = reinterpret_cast<const float*>(&vector);
    nlohmann::json result = nlohmann::json::array();
    for (std::size_t i = 0; i < sizeof(V) / sizeof(float); ++i) result.push_back(gltf_number(numbers[i]));
    return result;
}

} // namespace hachure::assets
