#include <hachure/runtime/ecs/component_json.h>
#include <hachure/systems/convert/camera_light.h>

#include <algorithm>

namespace hachure {
namespace {

using nlohmann::json;

json difference(const TypeInfo& type, const void* is, const void* read) {
    json result = json::object();
    for (const FieldInfo& field : type.fields)
        if (field.get(is) != field.get(read)) result[field.name] = to_json(field, field.get(is));
    return result;
}

/// glTF's ends of range; the component's 0 is none.
std::optional<float> end_of(float distance) { return distance > 0.0f ? std::optional(distance) : std::nullopt; }

} // namespace

assets::Camera gltf_camera(const Camera& camera, assets::Camera before) {
    before.orthographic = camera.projection == Projection::orthographic;
    before.yfov = camera.yfov;
    before.xmag = camera.ymag * (before.ymag > 0.0f ? before.xmag / before.ymag : 1.0f);
    before.ymag = camera.ymag;
    before.znear = camera.znear;
    before.zfar = end_of(camera.zfar);
    if (before.zfar && *before.zfar <= before.znear) before.zfar = std::nullopt; // nothing that glTF could say
    if (before.orthographic && !before.zfar) before.zfar = std::max(1000.0f * before.ymag, 2.0f * before.znear);
    return before;
}

json camera_extras(const TypeRegistry& types, const Camera& camera, const assets::Camera& written, bool first) {
    const Camera read{.projection = written.orthographic ? Projection::orthographic : Projection::perspective,
                      .yfov = written.orthographic ? camera.yfov : written.yfov,
                      .ymag = written.orthographic ? written.ymag : camera.ymag,
                      .znear = std::max(written.znear, 1e-6f),
                      .zfar = written.zfar.value_or(0.0f),
                      .active = first};
    return difference(*types.find("camera"), &camera, &read);
}

assets::Light gltf_light(const Light& light, assets::Light before) {
    before.kind = static_cast<assets::LightKind>(light.kind);
    before.color = light.color;
    before.intensity = light.intensity;
    before.range = end_of(light.range);
    before.inner_cone = std::min(light.inner_cone, light.outer_cone);
    before.outer_cone = light.outer_cone;
    return before;
}

json light_extras(const TypeRegistry& types, const Light& light, const assets::Light& written) {
    Light read = light;
    read.rig = LightRig::world;
    read.range = written.range.value_or(0.0f);
    return difference(*types.find("light"), &light, &read);
}

} // namespace hachure
