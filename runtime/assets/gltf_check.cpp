#include <hachure/runtime/assets/gltf_check.h>
#include <hachure/runtime/assets/gltf_check_data.h>
#include <hachure/runtime/assets/gltf_json.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// The order and the rules are those of the glTF 2.0 specification, section 5, "Properties Reference".
namespace hachure::assets {
namespace {

constexpr std::array understood = {
    std::string_view("EXT_meshopt_compression"), std::string_view("KHR_animation_pointer"),
    std::string_view("KHR_lights_punctual"),     std::string_view("KHR_mesh_quantization"),
    std::string_view("KHR_texture_transform"),
};

// "2.0" to 2; -1 when the text does not start with a number and a point.
int major_version(const std::string& version) {
    const std::size_t digits = version.find('.');
    if (digits == std::string::npos || digits == 0 || digits > 4) return -1;
    int major = 0;
    for (std::size_t i = 0; i < digits; ++i) {
        if (version[i] < '0' || version[i] > '9') return -1;
        major = major * 10 + (version[i] - '0');
    }
    return major;
}

void check_asset(const JsonPlace& root, const nlohmann::json& document) {
    root.object(
        "asset",
        [&](const JsonPlace& asset) {
            asset.string("version", Need::required);
            asset.string("minVersion");
            const auto& values = document.at("asset");
            const auto version = values.at("version").get<std::string>();
            if (major_version(version) != 2)
                asset.fail_at("version", fmt::format("is glTF {}; 2.x is understood", version.substr(0, 20)));
            const auto least = values.value("minVersion", "2.0");
            if (least != "2.0")
                asset.fail_at("minVersion", fmt::format("needs a reader of glTF {}", least.substr(0, 20)));
        },
        Need::required);
}

void check_extensions(const JsonPlace& root, const nlohmann::json& document) {
    root.strings("extensionsUsed");
    root.strings("extensionsRequired");
    if (!root.has("extensionsRequired")) return;
    for (const auto& name : document.at("extensionsRequired")) {
        const auto extension = name.get<std::string>();
        if (!understands_extension(extension))
            root.fail_at("extensionsRequired",
                         fmt::format("requires the extension {}, which is not understood", extension.substr(0, 100)));
    }
}

void check_texture_use(const JsonPlace& material, std::string_view key, const GltfCounts& counts) {
    material.object(key, [&](const JsonPlace& use) {
        use.index("index", counts.textures, Need::required);
        use.integer("texCoord", 0, 1'000);
        use.number("scale");
        use.extension("KHR_texture_transform", [](const JsonPlace& transform) {
            transform.numbers("offset", 2);
            transform.numbers("scale", 2);
            transform.number("rotation");
            transform.integer("texCoord", 0, 1'000);
        });
    });
}

void check_material(const JsonPlace& material, const GltfCounts& counts) {
    material.string("name");
    material.numbers("emissiveFactor", 3);
    material.choice("alphaMode", {"OPAQUE", "MASK", "BLEND"}, Need::optional);
    material.number("alphaCutoff");
    material.boolean("doubleSided");
    material.object("pbrMetallicRoughness", [&](const JsonPlace& pbr) {
        pbr.numbers("baseColorFactor", 4);
        pbr.number("metallicFactor");
        pbr.number("roughnessFactor");
        check_texture_use(pbr, "baseColorTexture", counts);
        check_texture_use(pbr, "metallicRoughnessTexture", counts);
    });
    check_texture_use(material, "normalTexture", counts);
    check_texture_use(material, "occlusionTexture", counts);
    check_texture_use(material, "emissiveTexture", counts);
}

void check_appearance(const JsonPlace& root, const GltfCounts& counts) {
    root.each("materials", [&](const JsonPlace& material) { check_material(material, counts); });
    root.each("textures", [&](const JsonPlace& texture) {
        texture.index("sampler", counts.samplers);
        texture.index("source", counts.images);
    });
    root.each("samplers", [](const JsonPlace& sampler) {
        for (const char* key : {"magFilter", "minFilter", "wrapS", "wrapT"}) sampler.integer(key, 0, 65'535);
    });
    root.each("images", [&](const JsonPlace& image) {
        image.string("name");
        image.string("uri");
        image.string("mimeType");
        image.index("bufferView", counts.buffer_views);
        if (image.has("uri") == image.has("bufferView")) image.fail("needs either 'uri' or 'bufferView'");
    });
}

void check_camera(const JsonPlace& camera) {
    camera.string("name");
    camera.choice("type", {"perspective", "orthographic"}, Need::required);
    const auto numbers = [](std::initializer_list<const char*> required, std::initializer_list<const char*> optional) {
        return [=](const JsonPlace& projection) {
            for (const char* key : required) projection.number(key, Need::required);
            for (const char* key : optional) projection.number(key);
        };
    };
    camera.object("perspective", numbers({"yfov", "znear"}, {"aspectRatio", "zfar"}));
    camera.object("orthographic", numbers({"xmag", "ymag", "znear", "zfar"}, {}));
    if (camera.has("perspective") == camera.has("orthographic"))
        camera.fail("needs either 'perspective' or 'orthographic'");
}

void check_lights(const JsonPlace& root) {
    root.extension("KHR_lights_punctual", [](const JsonPlace& extension) {
        extension.each(
            "lights",
            [](const JsonPlace& light) {
                light.string("name");
                light.choice("type", {"directional", "point", "spot"}, Need::required);
                light.numbers("color", 3);
                light.number("intensity");
                light.number("range");
                light.object("spot", [](const JsonPlace& spot) {
                    spot.number("innerConeAngle");
                    spot.number("outerConeAngle");
                });
            },
            Need::required);
    });
}

void check_node(const JsonPlace& node, const GltfCounts& counts) {
    node.string("name");
    node.index("camera", counts.cameras);
    node.index("mesh", counts.meshes);
    node.index("skin", counts.skins);
    node.indices("children", counts.nodes);
    node.numbers("matrix", 16);
    node.numbers("translation", 3);
    node.numbers("rotation", 4);
    node.numbers("scale", 3);
    node.numbers("weights", 0);
    node.extension("KHR_lights_punctual",
                   [&](const JsonPlace& light) { light.index("light", counts.lights, Need::required); });
}

void check_scenes(const JsonPlace& root, const GltfCounts& counts) {
    root.each("nodes", [&](const JsonPlace& node) { check_node(node, counts); });
    root.index("scene", counts.scenes);
    root.each("scenes", [&](const JsonPlace& scene) {
        scene.string("name");
        scene.indices("nodes", counts.nodes);
    });
    root.each("cameras", check_camera);
    check_lights(root);
}

GltfCounts count_arrays(const JsonPlace& root) {
    GltfCounts counts;
    counts.accessors = root.array_size("accessors");
    counts.buffers = root.array_size("buffers");
    counts.buffer_views = root.array_size("bufferViews");
    counts.cameras = root.array_size("cameras");
    counts.images = root.array_size("images");
    counts.materials = root.array_size("materials");
    counts.meshes = root.array_size("meshes");
    counts.nodes = root.array_size("nodes");
    counts.samplers = root.array_size("samplers");
    counts.scenes = root.array_size("scenes");
    counts.skins = root.array_size("skins");
    counts.textures = root.array_size("textures");
    // These weigh a kilobyte or more each once they are parsed, and come by the dozen.
    const std::size_t most = 65'536;
    const auto bound = [most](const JsonPlace& place, const char* key) {
        if (place.array_size(key) > most) place.fail_at(key, fmt::format("has more than {} elements", most));
    };
    for (const char* key : {"buffers", "cameras", "images", "materials", "samplers", "scenes", "skins", "textures"})
        bound(root, key);
    root.extension("KHR_lights_punctual", [&](const JsonPlace& lights) {
        bound(lights, "lights");
        counts.lights = lights.array_size("lights");
    });
    return counts;
}

} // namespace

bool understands_extension(std::string_view name) {
    return std::find(understood.begin(), understood.end(), name) != understood.end();
}

void check_gltf(nlohmann::json& document, const std::string& file) {
    const JsonPlace root(document, file);
    if (!document.is_object()) root.fail("must be an object");
    check_asset(root, document);
    check_extensions(root, document);
    const GltfCounts counts = count_arrays(root);
    check_gltf_data(root, counts);
    check_appearance(root, counts);
    check_scenes(root, counts);
}

} // namespace hachure::assets
