#include <hachure/runtime/assets/gltf_writer.h>

#include <string>
#include <utility>

namespace hachure::assets {
namespace {

using nlohmann::json;

template <class T>
void put(GltfWriter& writer, json& attributes, const std::string& name, const std::vector<T>& values) {
    if (!values.empty()) attributes[name] = writer.data.vectors(std::span(values), GltfTarget::vertices);
}

void put_positions(GltfWriter& writer, json& attributes, const std::vector<glm::vec3>& positions) {
    if (!positions.empty()) attributes["POSITION"] = writer.data.vectors(positions, GltfTarget::vertices, true);
}

json attributes_json(GltfWriter& writer, const Primitive& primitive) {
    json attributes = json::object();
    put_positions(writer, attributes, primitive.positions);
    put(writer, attributes, "NORMAL", primitive.normals);
    put(writer, attributes, "TANGENT", primitive.tangents);
    put(writer, attributes, "COLOR_0", primitive.colors);
    for (std::size_t set = 0; set < 2; ++set) {
        const std::string number = std::to_string(set);
        put(writer, attributes, "TEXCOORD_" + number, primitive.texcoords[set]);
        put(writer, attributes, "WEIGHTS_" + number, primitive.weights[set]);
        if (!primitive.joints[set].empty()) attributes["JOINTS_" + number] = writer.data.joints(primitive.joints[set]);
    }
    return attributes;
}

json primitive_json(GltfWriter& writer, const Primitive& primitive) {
    json result{{"attributes", attributes_json(writer, primitive)},
                {"indices", writer.data.indices(primitive.indices)}};
    if (primitive.material >= 0) result["material"] = primitive.material;
    for (const MorphTarget& target : primitive.morph_targets) {
        json attributes = json::object();
        put_positions(writer, attributes, target.positions);
        put(writer, attributes, "NORMAL", target.normals);
        put(writer, attributes, "TANGENT", target.tangents);
        // A target that moves nothing still counts: weights are given by its place.
        if (attributes.empty())
            put_positions(writer, attributes, std::vector<glm::vec3>(primitive.positions.size(), glm::vec3(0.0f)));
        result["targets"].push_back(std::move(attributes));
    }
    return result;
}

json mesh_json(GltfWriter& writer, const Mesh& mesh) {
    json result{{"primitives", json::array()}};
    if (!mesh.name.empty()) result["name"] = mesh.name;
    for (const Primitive& primitive : mesh.primitives)
        result["primitives"].push_back(primitive_json(writer, primitive));
    for (const float weight : mesh.morph_weights) result["weights"].push_back(gltf_number(weight));
    bool named = false;
    json names = json::array();
    for (const MorphTarget& target : mesh.primitives.front().morph_targets) {
        names.push_back(target.name);
        named |= !target.name.empty();
    }
    if (named) result["extras"]["targetNames"] = std::move(names);
    return result;
}

} // namespace

void write_meshes(GltfWriter& writer) {
    json meshes = json::array();
    for (const Mesh& mesh : writer.model.meshes) {
        writer.mesh_places.push_back(mesh.primitives.empty() ? -1 : static_cast<std::int32_t>(meshes.size()));
        if (!mesh.primitives.empty()) meshes.push_back(mesh_json(writer, mesh));
    }
    put_array(writer, "meshes", std::move(meshes));
}

} // namespace hachure::assets
