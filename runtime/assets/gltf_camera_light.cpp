#include <hachure/runtime/assets/gltf_numbers.h>
#include <hachure/runtime/assets/gltf_reader.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <numbers>

namespace hachure::assets {
namespace {

// tinygltf says 0 for what is absent.
std::optional<float> positive(double number) {
    return number > 0.0 ? std::optional(static_cast<float>(number)) : std::nullopt;
}

Camera perspective(const tinygltf::PerspectiveCamera& source) {
    Camera camera;
    camera.yfov = static_cast<float>(source.yfov);
    camera.aspect = positive(source.aspectRatio);
    camera.znear = static_cast<float>(source.znear);
    camera.zfar = positive(source.zfar);
    return camera;
}

Camera orthographic(const tinygltf::OrthographicCamera& source) {
    Camera camera;
    camera.orthographic = true;
    camera.xmag = static_cast<float>(source.xmag);
    camera.ymag = static_cast<float>(source.ymag);
    camera.znear = static_cast<float>(source.znear);
    camera.zfar = static_cast<float>(source.zfar);
    return camera;
}

// Whether a projection matrix can be made of it.
bool is_usable(const Camera& camera) {
    if (camera.zfar && !(*camera.zfar > camera.znear)) return false;
    if (camera.orthographic) return camera.znear >= 0.0f && camera.xmag != 0.0f && camera.ymag != 0.0f;
    return camera.znear > 0.0f && camera.yfov > 0.0f && camera.yfov < std::numbers::pi_v<float>;
}

LightKind kind_of(const std::string& type) {
    if (type == "point") return LightKind::point;
    return type == "spot" ? LightKind::spot : LightKind::directional;
}

} // namespace

void read_cameras(const GltfReader& reader, Model& model) {
    for (std::size_t i = 0; i < reader.document.model->cameras.size(); ++i) {
        const tinygltf::Camera& source = reader.document.model->cameras[i];
        Camera camera =
            source.type == "orthographic" ? orthographic(source.orthographic) : perspective(source.perspective);
        if (!is_usable(camera)) {
            reader.warnings.add("a camera whose numbers make no projection becomes the default one",
                                fmt::format("/cameras/{}", i));
            camera = Camera{};
        }
        camera.name = source.name;
        model.cameras.push_back(std::move(camera));
    }
}

void read_lights(const GltfReader& reader, Model& model) {
    constexpr float widest = std::numbers::pi_v<float> / 2.0f;
    for (const tinygltf::Light& source : reader.document.model->lights) {
        Light light;
        light.name = source.name;
        light.kind = kind_of(source.type);
        light.color = to_vector(source.color, light.color);
        light.intensity = static_cast<float>(source.intensity);
        light.range = positive(source.range);
        if (light.kind == LightKind::spot) {
            light.outer_cone = std::clamp(static_cast<float>(source.spot.outerConeAngle), 0.0f, widest);
            light.inner_cone = std::clamp(static_cast<float>(source.spot.innerConeAngle), 0.0f, light.outer_cone);
        }
        model.lights.push_back(std::move(light));
    }
}

} // namespace hachure::assets
