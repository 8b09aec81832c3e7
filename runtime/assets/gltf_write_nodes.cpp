#include <hachure/runtime/assets/gltf_writer.h>

#include <utility>

namespace hachure::assets {
namespace {

using nlohmann::json;

constexpr const char* lights_extension = "KHR_lights_punctual";

void put_transform(json& result, const Node& node) {
    if (node.matrix) {
        result["matrix"] = gltf_numbers(*node.matrix);
        return;
    }
    const glm::quat& q = node.rotation;
    if (node.translation != glm::vec3(0.0f)) result["translation"] = gltf_numbers(node.translation);
    if (q != glm::quat(1.0f, 0.0f, 0.0f, 0.0f)) result["rotation"] = gltf_numbers(glm::vec4(q.x, q.y, q.z, q.w));
    if (node.scale != glm::vec3(1.0f)) result["scale"] = gltf_numbers(node.scale);
}

json node_json(GltfWriter& writer, const Node& node) {
    json result = json::object();
    if (!node.name.empty()) result["name"] = node.name;
    put_transform(result, node);
    if (!node.children.empty()) result["children"] = node.children;
    if (const std::int32_t mesh = node.mesh < 0 ? -1 : writer.mesh_places[static_cast<std::size_t>(node.mesh)];
        mesh >= 0) {
        result["mesh"] = mesh;
        if (node.skin >= 0) result["skin"] = node.skin;
        for (const float weight : node.morph_weights) result["weights"].push_back(gltf_number(weight));
    }
    if (node.camera >= 0) result["camera"] = node.camera;
    if (node.light >= 0) result["extensions"][lights_extension]["light"] = node.light;
    write_extras(result, node.extras);
    return result;
}

json skin_json(GltfWriter& writer, const Skin& skin) {
    json result{{"joints", skin.joints}, {"inverseBindMatrices", writer.data.matrices(skin.inverse_bind)}};
    if (!skin.name.empty()) result["name"] = skin.name;
    if (skin.skeleton >= 0) result["skeleton"] = skin.skeleton;
    return result;
}

json camera_json(const Camera& camera) {
    json result = json::object();
    if (!camera.name.empty()) result["name"] = camera.name;
    result["type"] = camera.orthographic ? "orthographic" : "perspective";
    json& projection = result[camera.orthographic ? "orthographic" : "perspective"];
    projection["znear"] = gltf_number(camera.znear);
    if (camera.zfar) projection["zfar"] = gltf_number(*camera.zfar);
    if (camera.orthographic) {
        projection["xmag"] = gltf_number(camera.xmag);
        projection["ymag"] = gltf_number(camera.ymag);
        // glTF has no orthographic camera that sees without end; Hachure's see that far (components/camera.h).
        if (!camera.zfar) projection["zfar"] = gltf_number(1000.0f * camera.ymag);
    } else {
        projection["yfov"] = gltf_number(camera.yfov);
        if (camera.aspect) projection["aspectRatio"] = gltf_number(*camera.aspect);
    }
    return result;
}

json light_json(const Light& light) {
    static constexpr const char* kinds[] = {"directional", "point", "spot"};
    json result{{"type", kinds[static_cast<std::size_t>(light.kind)]},
                {"color", gltf_numbers(light.color)},
                {"intensity", gltf_number(light.intensity)}};
    if (!light.name.empty()) result["name"] = light.name;
    if (light.range) result["range"] = gltf_number(*light.range);
    if (light.kind == LightKind::spot)
        result["spot"] = {{"innerConeAngle", gltf_number(light.inner_cone)},
                          {"outerConeAngle", gltf_number(light.outer_cone)}};
    return result;
}

void write_cameras_and_lights(GltfWriter& writer) {
    json cameras = json::array(), lights = json::array();
    for (const Camera& camera : writer.model.cameras) cameras.push_back(camera_json(camera));
    for (const Light& light : writer.model.lights) lights.push_back(light_json(light));
    put_array(writer, "cameras", std::move(cameras));
    if (lights.empty()) return;
    writer.extensions.insert(lights_extension);
    writer.root["extensions"][lights_extension]["lights"] = std::move(lights);
}

void write_scenes(GltfWriter& writer) {
    json scenes = json::array();
    for (const Scene& scene : writer.model.scenes) {
        json& written = scenes.emplace_back(json::object());
        if (!scene.name.empty()) written["name"] = scene.name;
        if (!scene.roots.empty()) written["nodes"] = scene.roots;
        write_extras(written, scene.extras);
    }
    put_array(writer, "scenes", std::move(scenes));
    if (!writer.model.scenes.empty()) writer.root["scene"] = writer.model.default_scene;
}

} // namespace

void write_nodes(GltfWriter& writer) {
    json nodes = json::array(), skins = json::array();
    for (const Node& node : writer.model.nodes) nodes.push_back(node_json(writer, node));
    for (const Skin& skin : writer.model.skins) skins.push_back(skin_json(writer, skin));
    put_array(writer, "nodes", std::move(nodes));
    put_array(writer, "skins", std::move(skins));
    write_cameras_and_lights(writer);
    write_scenes(writer);
}

} // namespace hachure::assets
