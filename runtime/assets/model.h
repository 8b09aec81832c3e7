#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What a model file says, as plain data. Conventions are glTF's: right-handed, Y up, metres, radians,
/// counter-clockwise front faces, linear colour factors. A Model that a reader returns is valid: every index is in
/// range, every array of a primitive is empty or has one element per vertex, every float is finite, the node graph is a
/// forest.
namespace hachure::assets {

/// Displacements of one morph target; each array is empty or has one element per vertex of its primitive.
struct MorphTarget {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec3> tangents;
};

/// Indexed triangles that share one material.
struct Primitive {
    std::vector<glm::vec3> positions; ///< metres
    std::vector<glm::vec3> normals;   ///< unit; always present after loading
    std::vector<glm::vec4> tangents;  ///< xyz unit, w = +-1 handedness; may be empty
    std::vector<glm::vec2> texcoords[2];
    std::vector<glm::vec4> colors;          ///< linear RGBA; may be empty
    std::vector<glm::u16vec4> joints[2];    ///< indices into the skin's joints, 4 or 8 influences; may be empty
    std::vector<glm::vec4> weights[2];      ///< weight of each influence, as the file has them
    std::vector<std::uint32_t> indices;     ///< 3 per triangle; strips and fans are unrolled on loading
    std::int32_t material = -1;             ///< into Model::materials, -1 for the default material
    std::vector<MorphTarget> morph_targets; ///< same count for all primitives of a mesh
    bool normals_computed = false;          ///< the file had none; they come from geometry::vertex_normals
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
    std::vector<float> morph_weights; ///< defaults, one per morph target, or empty
};

enum class Wrap : std::uint8_t { repeat, clamp, mirror };
enum class Filter : std::uint8_t { nearest, linear };

struct Texture {
    std::int32_t image = -1; ///< into Model::images, -1 when its image could not be understood
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
    Filter magnify = Filter::linear;
    Filter minify = Filter::linear;
    bool mipmaps = true;
};

/// An encoded image (PNG, JPEG, ...) as it stands in or beside the file; `read_image_memory` decodes it when needed.
struct EncodedImage {
    std::string name; ///< its file, or "image 3" for one inside a buffer: for messages
    std::vector<std::byte> bytes;
};

/// A texture as a material uses it, KHR_texture_transform included: uv' = offset + rotate(scale * uv).
struct TextureUse {
    std::int32_t texture = -1; ///< into Model::textures, -1 for none
    std::int32_t texcoord = 0; ///< which set, 0 or 1
    glm::vec2 offset{0.0f};
    glm::vec2 scale{1.0f};
    float rotation = 0.0f; ///< radians, counter-clockwise
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

struct Material {
    std::string name;
    glm::vec4 base_color{1.0f}; ///< linear RGBA
    TextureUse base_color_texture;
    float metallic = 1.0f;
    float roughness = 1.0f;
    TextureUse metallic_roughness_texture;
    TextureUse normal_texture;
    float normal_scale = 1.0f;
    glm::vec3 emissive{0.0f};
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    TextureUse emissive_texture;  ///< kept for writing; nothing draws it yet
    TextureUse occlusion_texture; ///< the same
    float occlusion_strength = 1.0f;
    std::string extras{}; ///< what it says to Hachure, see gltf_extras.h; of the surfaces that use it
};

struct Camera {
    std::string name;
    bool orthographic = false;
    float yfov = 0.8f;              ///< radians, full vertical angle (perspective)
    std::optional<float> aspect;    ///< width / height; the view's when absent (perspective)
    float xmag = 1.0f, ymag = 1.0f; ///< half width and height, metres (orthographic)
    float znear = 0.01f;            ///< metres
    std::optional<float> zfar;      ///< metres; infinite when absent (perspective)
};

enum class LightKind : std::uint8_t { directional, point, spot };

/// KHR_lights_punctual: shines along the node's -Z.
struct Light {
    std::string name;
    LightKind kind = LightKind::directional;
    glm::vec3 color{1.0f};      ///< linear RGB
    float intensity = 1.0f;     ///< lux (directional) or candela
    std::optional<float> range; ///< metres; infinite when absent
    float inner_cone = 0.0f;    ///< radians (spot)
    float outer_cone = 0.785398f;
};

/// `translation * rotation * scale` when `matrix` is absent; a matrix that does not decompose is kept as it is.
struct Node {
    std::string name;
    std::int32_t parent = -1;
    std::vector<std::int32_t> children;
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< unit
    glm::vec3 scale{1.0f};
    std::optional<glm::mat4> matrix;
    std::int32_t mesh = -1, skin = -1, camera = -1, light = -1; ///< into the Model's arrays, -1 for none
    std::vector<float> morph_weights;                           ///< override the mesh's when not empty
    std::string extras{}; ///< what it says to Hachure, see gltf_extras.h; of its entity
};

struct Skin {
    std::string name;
    std::vector<std::int32_t> joints;    ///< nodes
    std::vector<glm::mat4> inverse_bind; ///< one per joint (identity where the file has none)
    std::int32_t skeleton = -1;          ///< node, or -1
};

enum class Interpolation : std::uint8_t { step, linear, cubic_spline };
enum class AnimationPath : std::uint8_t { translation, rotation, scale, weights, pointer };

struct AnimationChannel {
    std::int32_t node = -1; ///< -1 for a pointer channel
    AnimationPath path = AnimationPath::translation;
    std::string pointer; ///< KHR_animation_pointer's JSON pointer
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times;  ///< seconds, as the file has them (order is not checked here)
    std::vector<float> values; ///< `components` floats per key, three keys' worth per time for cubic_spline
    std::int32_t components = 0;
};

struct Animation {
    std::string name;
    std::vector<AnimationChannel> channels;
    float duration = 0.0f; ///< seconds, the last key of any channel
};

struct Scene {
    std::string name;
    std::vector<std::int32_t> roots; ///< nodes
    std::string extras{};            ///< what it says to Hachure, see gltf_extras.h; of the model as a whole
};

struct Model {
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<EncodedImage> images;
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<Node> nodes;
    std::vector<Skin> skins;
    std::vector<Animation> animations;
    std::vector<Scene> scenes;           ///< never empty after loading
    std::int32_t default_scene = 0;      ///< into scenes
    std::vector<std::string> extensions; ///< what the file declares as used, in its order
    std::vector<std::string> warnings;   ///< one line per thing that was repaired or not understood, each kind once
    std::filesystem::path file;          ///< where it was read from; empty for what was made in memory
};

} // namespace hachure::assets
