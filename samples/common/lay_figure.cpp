#include <hachure/samples/common/lay_figure.h>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace samples {
namespace {

using namespace hachure;

constexpr float turn = glm::two_pi<float>();

/// Joints, in the order of the skin; those of the right side follow those of the left.
enum Joint : std::uint16_t {
    hips,
    chest,
    head,
    left_arm,
    left_forearm,
    right_arm,
    right_forearm,
    left_thigh,
    left_shin,
    right_thigh,
    right_shin,
    joint_count
};

struct JointPlace {
    const char* name;
    int parent;   ///< -1 for none
    glm::vec3 at; ///< in the rest pose of a figure of height 1, feet at 0
};

constexpr std::array<JointPlace, joint_count> skeleton{{
    {"hips", -1, {0, 0.53f, 0}},
    {"chest", hips, {0, 0.64f, 0}},
    {"head", chest, {0, 0.84f, 0}},
    {"left arm", chest, {0.115f, 0.79f, 0}},
    {"left forearm", left_arm, {0.14f, 0.63f, 0}},
    {"right arm", chest, {-0.115f, 0.79f, 0}},
    {"right forearm", right_arm, {-0.14f, 0.63f, 0}},
    {"left thigh", hips, {0.06f, 0.51f, 0}},
    {"left shin", left_thigh, {0.065f, 0.28f, 0}},
    {"right thigh", hips, {-0.06f, 0.51f, 0}},
    {"right shin", right_thigh, {-0.065f, 0.28f, 0}},
}};

/// A limb with round ends about a straight axis. Lengths are those of a figure of height 1.
struct Limb {
    glm::vec3 from, to;
    float start_radius, middle_radius, end_radius;
    float depth; ///< of the cross-section along Z, as a part of its width
    Joint first, second;
    float bend; ///< where along the axis, 0 to 1, the second joint takes over from the first
};

class FigureMesh {
public:
    explicit FigureMesh(const Build& build) : build_(build) {}

    void add(const Limb& limb) {
        constexpr std::uint32_t rings = 40, sides = 28;
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (std::uint32_t ring = 0; ring <= rings; ++ring)
            for (std::uint32_t side = 0; side < sides; ++side) {
                // Rings lie closer where the ends are round.
                const float t = 0.5f - 0.5f * std::cos(glm::pi<float>() * float(ring) / rings);
                add_vertex(limb, t, turn * float(side) / sides);
            }
        for (std::uint32_t ring = 0; ring < rings; ++ring)
            for (std::uint32_t side = 0; side < sides; ++side) {
                // Rings at both ends are points.
                const std::uint32_t a = first + ring * sides + side, b = first + ring * sides + (side + 1) % sides;
                if (ring > 0) mesh_.indices.insert(mesh_.indices.end(), {a, a + sides, b});
                if (ring + 1 < rings) mesh_.indices.insert(mesh_.indices.end(), {b, a + sides, b + sides});
            }
    }

    [[nodiscard]] assets::Primitive take() { return std::move(mesh_); }

private:
    void add_vertex(const Limb& limb, float t, float angle) {
        constexpr float h = 1e-3f;
        mesh_.positions.push_back(build_.height * place(limb, t, angle));
        const float inside = glm::clamp(t, 2.0f * h, 1.0f - 2.0f * h); // at its very ends the surface has no tangents
        const glm::vec3 along = place(limb, inside + h, angle) - place(limb, inside - h, angle);
        const glm::vec3 around = place(limb, inside, angle + h) - place(limb, inside, angle - h);
        const glm::vec3 axis = glm::normalize(limb.to - limb.from);
        const bool end = t < h || t > 1.0f - h;
        mesh_.normals.push_back(end ? (t < 0.5f ? -axis : axis) : glm::normalize(glm::cross(along, around)));
        const float second = glm::smoothstep(limb.bend - 0.12f, limb.bend + 0.12f, t);
        mesh_.joints[0].emplace_back(limb.first, limb.second, 0, 0);
        mesh_.weights[0].emplace_back(1.0f - second, second, 0.0f, 0.0f);
    }

    [[nodiscard]] glm::vec3 place(const Limb& limb, float t, float angle) const {
        const glm::vec3 axis = glm::normalize(limb.to - limb.from);
        // Limbs that point forward, feet, have their width along X and their depth along Y.
        const glm::vec3 side =
            glm::normalize(glm::cross(axis, std::abs(axis.z) > 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1)));
        const glm::vec3 front = glm::cross(side, axis);
        const float radius = build_.girth * radius_at(limb, t);
        return glm::mix(limb.from, limb.to, t) +
               radius * (std::cos(angle) * side + limb.depth * std::sin(angle) * front);
    }

    /// A parabola through the three radii, rounded off at both ends.
    static float radius_at(const Limb& limb, float t) {
        const float s = 2.0f * t - 1.0f;
        const float parabola = limb.middle_radius + 0.5f * (limb.end_radius - limb.start_radius) * s +
                               0.5f * (limb.start_radius + limb.end_radius - 2.0f * limb.middle_radius) * s * s;
        return parabola * std::sqrt(glm::max(0.0f, 1.0f - s * s * s * s * s * s));
    }

    Build build_;
    assets::Primitive mesh_;
};

assets::Primitive figure_mesh(const Build& build) {
    FigureMesh mesh(build);
    mesh.add({{0, 0.46f, 0}, {0, 0.84f, 0}, 0.09f, 0.075f, 0.105f, 0.7f, hips, chest, 0.45f});
    mesh.add({{0, 0.80f, 0}, {0, 0.88f, 0.005f}, 0.035f, 0.035f, 0.035f, 1.0f, chest, head, 0.5f});
    mesh.add({{0, 0.85f, 0.01f}, {0, 1.0f, 0.01f}, 0.05f, 0.068f, 0.055f, 1.1f, head, head, 0.5f});
    for (const bool right : {false, true}) {
        const float x = right ? -1.0f : 1.0f;
        const auto of = [&](Joint left, Joint other) { return right ? other : left; };
        const Joint arm = of(left_arm, right_arm), forearm = of(left_forearm, right_forearm);
        const Joint thigh = of(left_thigh, right_thigh), shin = of(left_shin, right_shin);
        mesh.add({{0.11f * x, 0.83f, 0}, {0.165f * x, 0.43f, 0.01f}, 0.042f, 0.032f, 0.024f, 1.0f, arm, forearm, 0.5f});
        mesh.add({{0.055f * x, 0.58f, 0}, {0.07f * x, 0.02f, 0}, 0.078f, 0.05f, 0.03f, 1.0f, thigh, shin, 0.52f});
        mesh.add(
            {{0.07f * x, 0.032f, -0.045f}, {0.075f * x, 0.028f, 0.115f}, 0.03f, 0.036f, 0.03f, 0.8f, shin, shin, 0.5f});
    }
    assets::Primitive result = mesh.take();
    result.material = 0;
    return result;
}

/// The angle of a joint about X at a phase of the loop, radians; forward is negative.
float swing(int joint, float phase) {
    const float left = std::sin(phase), right = -left;
    // A knee bends while its leg comes forward, most where it passes the other.
    const auto knee = [&](float leg_phase) {
        return 0.12f + 0.85f * std::pow(glm::max(0.0f, std::cos(leg_phase)), 2.0f);
    };
    switch (joint) {
    case left_thigh:
        return -0.45f * left - 0.1f;
    case right_thigh:
        return -0.45f * right - 0.1f;
    case left_shin:
        return knee(phase - 0.3f);
    case right_shin:
        return knee(phase - 0.3f + glm::pi<float>());
    case left_arm:
        return -0.5f * right;
    case right_arm:
        return -0.5f * left;
    case left_forearm:
        return -0.45f - 0.2f * right;
    case right_forearm:
        return -0.45f - 0.2f * left;
    case chest:
        return 0.08f;
    default:
        return 0.0f;
    }
}

constexpr int keys = 24;
constexpr float loop_seconds = 1.2f;

/// A channel of `keys` and the first again; `value(phase)` writes the components of one key.
template <class F> assets::AnimationChannel channel(int node, assets::AnimationPath path, int components, F value) {
    assets::AnimationChannel result{.node = node, .path = path, .components = components};
    for (int key = 0; key <= keys; ++key) {
        const float t = float(key) / keys;
        result.times.push_back(t * loop_seconds);
        const auto parts = value(turn * t);
        result.values.insert(result.values.end(), parts.begin(), parts.end());
    }
    return result;
}

assets::Animation walk_clip(const Build& build) {
    assets::Animation clip{.name = "walk", .channels = {}, .duration = loop_seconds};
    for (int joint = 1; joint < joint_count; ++joint)
        clip.channels.push_back(channel(1 + joint, assets::AnimationPath::rotation, 4, [&](float phase) {
            // The chest turns against the hips.
            const glm::quat about_y =
                glm::angleAxis(joint == chest ? 0.12f * std::sin(phase) : 0.0f, glm::vec3(0, 1, 0));
            const glm::quat q = about_y * glm::angleAxis(swing(joint, phase), glm::vec3(1, 0, 0));
            return std::array{q.x, q.y, q.z, q.w};
        }));
    // Hips are lowest when the legs are farthest apart, twice a loop.
    clip.channels.push_back(channel(1 + hips, assets::AnimationPath::translation, 3, [&](float phase) {
        return std::array{0.0f, build.height * (skeleton[hips].at.y - 0.018f + 0.01f * std::cos(2.0f * phase)), 0.0f};
    }));
    return clip;
}

} // namespace

assets::Model lay_figure(const Build& build) {
    assets::Model model;
    model.materials.push_back({.name = "wood", .base_color = {0.75f, 0.68f, 0.58f, 1.0f}});
    model.meshes.push_back({"lay figure", {figure_mesh(build)}, {}});
    model.nodes.resize(1 + joint_count);
    model.nodes[0] = {.name = "lay figure", .mesh = 0, .skin = 0};
    assets::Skin skin{.name = "lay figure", .joints = {}, .inverse_bind = {}};
    for (int joint = 0; joint < joint_count; ++joint) {
        const auto& place = skeleton[static_cast<std::size_t>(joint)];
        const glm::vec3 above = place.parent < 0 ? glm::vec3(0) : skeleton[static_cast<std::size_t>(place.parent)].at;
        assets::Node& node = model.nodes[static_cast<std::size_t>(1 + joint)];
        node.name = place.name;
        node.translation = build.height * (place.at - above);
        node.parent = place.parent < 0 ? -1 : 1 + place.parent;
        if (place.parent >= 0) model.nodes[static_cast<std::size_t>(1 + place.parent)].children.push_back(1 + joint);
        skin.joints.push_back(1 + joint);
        skin.inverse_bind.push_back(glm::translate(glm::mat4(1.0f), -build.height * place.at));
    }
    model.skins.push_back(std::move(skin));
    model.animations.push_back(walk_clip(build));
    model.scenes.push_back({"scene", {0, 1}});
    return model;
}

} // namespace samples
