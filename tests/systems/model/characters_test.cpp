// Real characters through the whole of it - file, clips, nodes, skins, morph targets - against the formulas of the glTF
// specification in double precision, straight from the file.

#include <hachure/components/animation.h>
#include <hachure/components/deformed.h>
#include <hachure/components/rig.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/tests/runtime/animation/gltf_sampling.h>
#include <hachure/tests/support/given_models.h>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <vector>

namespace hachure::test {
namespace {

using assets::AnimationPath;
using assets::Model;

/// A model at a moment of a clip.
class Reference {
public:
    Reference(const Model& model, const assets::Animation* clip, double time) : model_(model) {
        for (const assets::Node& node : model.nodes) {
            parts_.push_back({glm::dvec3(node.translation), glm::dquat(node.rotation), glm::dvec3(node.scale)});
            weights_.emplace_back(node.morph_weights.begin(), node.morph_weights.end());
        }
        if (clip)
            for (const assets::AnimationChannel& channel : clip->channels) apply(channel, time);
    }

    glm::dmat4 world(std::int32_t index) const {
        const auto i = static_cast<std::size_t>(index);
        const assets::Node& node = model_.nodes[i];
        const Parts& p = parts_[i];
        const glm::dmat4 local = node.matrix ? glm::dmat4(*node.matrix)
                                             : glm::translate(glm::dmat4(1.0), p.translation) *
                                                   glm::mat4_cast(p.rotation) * glm::scale(glm::dmat4(1.0), p.scale);
        return node.parent < 0 ? local : world(node.parent) * local;
    }

    /// The vertices of a node's mesh with their normals, all primitives one after the other; in the scene's space where
    /// it is skinned, else in the node's.
    void shape(const assets::Node& node, std::size_t index, std::vector<glm::dvec3>& positions,
               std::vector<glm::dvec3>& normals) const {
        const assets::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
        std::vector<double> weights = weights_[index];
        if (weights.empty()) weights.assign(mesh.morph_weights.begin(), mesh.morph_weights.end());
        std::vector<glm::dmat4> joints;
        if (node.skin >= 0) {
            const assets::Skin& skin = model_.skins[static_cast<std::size_t>(node.skin)];
            for (std::size_t j = 0; j < skin.joints.size(); ++j)
                joints.push_back(world(skin.joints[j]) * glm::dmat4(skin.inverse_bind[j]));
        }
        for (const assets::Primitive& primitive : mesh.primitives)
            for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
                glm::dvec3 position(primitive.positions[v]), normal(primitive.normals[v]);
                morph(primitive, weights, v, position, normal);
                if (!joints.empty()) skin(primitive, joints, v, position, normal);
                positions.push_back(position);
                normals.push_back(normal);
            }
    }

private:
    struct Parts {
        glm::dvec3 translation;
        glm::dquat rotation;
        glm::dvec3 scale;
    };

    void apply(const assets::AnimationChannel& channel, double time) {
        if (channel.node < 0) return;
        const auto node = static_cast<std::size_t>(channel.node);
        const gltf_sampling::Value v = gltf_sampling::sample(channel, time);
        if (channel.path == AnimationPath::translation) parts_[node].translation = {v[0], v[1], v[2]};
        if (channel.path == AnimationPath::rotation) parts_[node].rotation = glm::dquat(v[3], v[0], v[1], v[2]);
        if (channel.path == AnimationPath::scale) parts_[node].scale = {v[0], v[1], v[2]};
        if (channel.path == AnimationPath::weights) weights_[node] = v;
    }

    static void morph(const assets::Primitive& primitive, const std::vector<double>& weights, std::size_t v,
                      glm::dvec3& position, glm::dvec3& normal) {
        for (std::size_t t = 0; t < std::min(weights.size(), primitive.morph_targets.size()); ++t) {
            const assets::MorphTarget& target = primitive.morph_targets[t];
            if (!target.positions.empty()) position += weights[t] * glm::dvec3(target.positions[v]);
            if (!target.normals.empty()) normal += weights[t] * glm::dvec3(target.normals[v]);
        }
        normal = glm::normalize(normal);
    }

    static void skin(const assets::Primitive& primitive, const std::vector<glm::dmat4>& joints, std::size_t v,
                     glm::dvec3& position, glm::dvec3& normal) {
        glm::dmat4 blended(0.0);
        double total = 0.0;
        for (int set = 0; set < 2; ++set)
            for (int k = 0; k < 4 && !primitive.joints[set].empty(); ++k) {
                const double weight = primitive.weights[set][v][k];
                blended += weight * joints[primitive.joints[set][v][k]];
                total += weight;
            }
        if (total <= 0.0) return;
        blended /= total;
        position = glm::dvec3(blended * glm::dvec4(position, 1.0));
        normal = glm::normalize(glm::inverseTranspose(glm::dmat3(blended)) * normal);
    }

    const Model& model_;
    std::vector<Parts> parts_;
    std::vector<std::vector<double>> weights_;
};

/// How far off the worst was.
struct Worst {
    double transform = 0.0, position = 0.0, normal = 0.0; ///< relative to the size of the model; of unit vectors
};

class Character {
public:
    explicit Character(const std::filesystem::path& file) : model_(assets::read_model(file)) {
        register_transform(app_);
        register_animation(app_);
        register_deform(app_);
        spawned_ = spawn_model(app_.world(), model_);
        for (const glm::vec3& point : spawned_.points) size_ = std::max<double>(size_, glm::length(point));
        if (const Rig* rig = app_.world().find<Rig>(spawned_.root)) nodes_ = rig->nodes;
    }

    const Model& model() const { return model_; }

    /// As the file itself stands.
    Worst compare_rest() {
        app_.run_frame();
        return compare(Reference(model_, nullptr, 0.0));
    }

    Worst compare(std::size_t clip, double time) {
        World& world = app_.world();
        world.add(spawned_.root,
                  Animation{.clip = spawned_.clips[clip], .repeat = Repeat::once, .fade = 0, .time = time});
        app_.run_frame();
        return compare(Reference(model_, &model_.animations[clip], time));
    }

private:
    Worst compare(const Reference& reference) {
        World& world = app_.world();
        Worst worst;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const WorldTransform* place = world.find<WorldTransform>(nodes_[i]);
            if (!place) continue;
            const glm::dmat4 want = reference.world(static_cast<std::int32_t>(i));
            double largest = size_;
            for (int c = 0; c < 4; ++c) largest = std::max(largest, glm::length(want[c]));
            for (int c = 0; c < 4; ++c)
                worst.transform =
                    std::max(worst.transform, glm::distance(glm::dvec4(place->matrix[c]), want[c]) / largest);
        }
        compare_shapes(reference, worst);
        return worst;
    }

    void compare_shapes(const Reference& reference, Worst& worst) {
        std::size_t surface = 0;
        for (const std::size_t index : surface_nodes()) {
            const Deformed* shape = app_.world().find<Deformed>(spawned_.surfaces[surface++]);
            if (!shape) continue;
            std::vector<glm::dvec3> positions, normals;
            reference.shape(model_.nodes[index], index, positions, normals);
            ASSERT_EQ(shape->positions.size(), positions.size());
            double size = 1e-9;
            for (const glm::dvec3& position : positions) size = std::max(size, glm::length(position));
            for (std::size_t v = 0; v < positions.size(); ++v) {
                worst.position =
                    std::max(worst.position, glm::distance(glm::dvec3(shape->positions[v]), positions[v]) / size);
                worst.normal = std::max(worst.normal, glm::distance(glm::dvec3(shape->normals[v]), normals[v]));
            }
        }
    }

    /// The nodes with meshes in the order in which they are spawned: depth first.
    std::vector<std::size_t> surface_nodes() const {
        std::vector<std::size_t> result;
        const auto& roots = model_.scenes[static_cast<std::size_t>(model_.default_scene)].roots;
        std::vector<std::int32_t> pending(roots.rbegin(), roots.rend());
        while (!pending.empty()) {
            const auto index = static_cast<std::size_t>(pending.back());
            pending.pop_back();
            if (model_.nodes[index].mesh >= 0) result.push_back(index);
            const auto& children = model_.nodes[index].children;
            pending.insert(pending.end(), children.rbegin(), children.rend());
        }
        return result;
    }

    Model model_;
    App app_;
    SpawnedModel spawned_;
    std::vector<Entity> nodes_;
    double size_ = 1e-9;
};

class GivenCharacters : public GivenModelTest {};

TEST_P(GivenCharacters, MoveAsTheSpecificationSays) {
    Character character(file());
    Worst worst = character.compare_rest();
    const auto& clips = character.model().animations;
    for (std::size_t clip = 0; clip < clips.size(); ++clip)
        for (const double part : {0.0, 0.31, 0.77, 1.0}) {
            const Worst here = character.compare(clip, part * clips[clip].duration);
            worst.transform = std::max(worst.transform, here.transform);
            worst.position = std::max(worst.position, here.position);
            worst.normal = std::max(worst.normal, here.normal);
        }
    RecordProperty("transform", std::to_string(worst.transform));
    RecordProperty("position", std::to_string(worst.position));
    RecordProperty("normal", std::to_string(worst.normal));
    EXPECT_LE(worst.transform, 1e-5);
    EXPECT_LE(worst.position, 1e-5);
    EXPECT_LE(worst.normal, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(
    Folder, GivenCharacters,
    ::testing::Values("characters/khronos/CesiumMan.glb", "characters/khronos/RiggedFigure.glb",
                      "characters/khronos/RiggedSimple.glb", "characters/khronos/Fox.glb",
                      "characters/khronos/RecursiveSkeletons.glb", "characters/khronos/InterpolationTest.glb",
                      "characters/khronos/BoxAnimated.glb", "characters/khronos/SimpleSkin.gltf",
                      "characters/morph/MorphStressTest.glb", "characters/morph/MorphPrimitivesTest.glb",
                      "characters/morph/AnimatedMorphSphere.glb", "characters/morph/AnimatedMorphCube.glb",
                      "characters/morph/SimpleMorph.gltf", "characters/kaykit/Knight.glb",
                      "characters/kaykit_manny/Med_MovementBasic.glb", "characters/kaykit_manny/manny_med_mod.gltf",
                      "characters/quaternius/Ninja.gltf", "characters/quaternius/Dino.gltf",
                      "characters/quaternius/Frog.gltf", "characters/quaternius/Alien.gltf",
                      "characters/godot_platformer_player.glb", "characters/cge_knight/knight.gltf",
                      "characters/luanti_spider.gltf", "mechanical/CesiumMilkTruck.glb", "mechanical/cannon.glb",
                      "mechanical/cge_gears/gears.gltf"),
    given_model_name);

} // namespace
} // namespace hachure::test
