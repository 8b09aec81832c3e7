#include <hachure/runtime/assets/gltf_numbers.h>
#include <hachure/runtime/assets/gltf_reader.h>

#include <fmt/format.h>
#include <glm/matrix.hpp>
#include <tiny_gltf.h>

#include <algorithm>

namespace hachure::assets {
namespace {

/// Matrices that the file lacks are identities: glTF says so for a skin without any, and it is the best guess where
/// there are too few.
std::vector<glm::mat4> read_inverse_bind(const GltfReader& reader, int accessor, std::size_t joints,
                                         const std::string& skin) {
    const std::string place = accessor < 0 ? "/skins" : accessor_pointer(accessor);
    reader.accessors.spend_elements(joints, sizeof(glm::mat4), place);
    std::vector<glm::mat4> matrices(joints, glm::mat4(1.0f));
    if (accessor < 0) {
        reader.warnings.add(fmt::format("{} has no inverse bind matrices: its joints bind as identities", skin));
        return matrices;
    }
    const AccessorShape shape = reader.accessors.shape(accessor);
    if (shape.columns != 4) reader.document.fail("inverse bind matrices must be MAT4", place);
    if (shape.count < joints)
        reader.warnings.add(fmt::format("{} has {} inverse bind matrices for {} joints: the others bind as identities",
                                        skin, shape.count, joints));
    const std::vector<float> numbers = reader.accessors.floats(accessor);
    if (!all_finite(numbers)) reader.document.fail("has an inverse bind matrix that is not finite", place);
    for (std::size_t i = 0; i < std::min(joints, shape.count) * 16; ++i)
        matrices[i / 16][static_cast<int>(i / 4 % 4)][static_cast<int>(i % 4)] = numbers[i];
    if (std::ranges::any_of(matrices, [](const glm::mat4& m) { return glm::determinant(glm::dmat4(m)) == 0.0; }))
        reader.warnings.add(fmt::format("{} has an inverse bind matrix that flattens what it binds", skin));
    return matrices;
}

// An index beyond the joints is a fault where it has weight; where it has none it becomes 0. Returns whether it found
// one of the latter.
bool repair_joints(const GltfReader& reader, Primitive& primitive, std::size_t joints, const std::string& where) {
    bool repaired = false;
    for (int set = 0; set < 2; ++set) {
        for (std::size_t vertex = 0; vertex < primitive.joints[set].size(); ++vertex) {
            for (int i = 0; i < 4; ++i) {
                std::uint16_t& joint = primitive.joints[set][vertex][i];
                if (joint < joints) continue;
                if (primitive.weights[set][vertex][i] != 0.0f)
                    reader.document.fail(fmt::format("has the joint {} in a skin of {}", joint, joints), where);
                joint = 0;
                repaired = true;
            }
        }
    }
    return repaired;
}

// The fewest joints of any skin that each mesh is drawn with.
void check_joint_indices(const GltfReader& reader, Model& model) {
    constexpr std::size_t unskinned = ~std::size_t{0};
    std::vector<std::size_t> fewest(model.meshes.size(), unskinned);
    for (const Node& node : model.nodes) {
        if (node.mesh < 0 || node.skin < 0) continue;
        std::size_t& joints = fewest[static_cast<std::size_t>(node.mesh)];
        joints = std::min(joints, model.skins[static_cast<std::size_t>(node.skin)].joints.size());
    }
    for (std::size_t mesh = 0; mesh < model.meshes.size(); ++mesh) {
        if (fewest[mesh] == unskinned) continue;
        const std::string where = fmt::format("/meshes/{}", mesh);
        for (Primitive& primitive : model.meshes[mesh].primitives)
            if (repair_joints(reader, primitive, fewest[mesh], where))
                reader.warnings.add("joint indices beyond the skin that have no weight become 0", where);
    }
}

} // namespace

void read_skins(const GltfReader& reader, Model& model) {
    for (std::size_t i = 0; i < reader.document.model->skins.size(); ++i) {
        const tinygltf::Skin& source = reader.document.model->skins[i];
        if (source.joints.empty()) reader.document.fail("has a skin without joints", fmt::format("/skins/{}", i));
        Skin skin;
        skin.name = source.name;
        skin.joints.assign(source.joints.begin(), source.joints.end());
        skin.inverse_bind =
            read_inverse_bind(reader, source.inverseBindMatrices, skin.joints.size(),
                              source.name.empty() ? fmt::format("skin {}", i) : fmt::format("skin '{}'", source.name));
        skin.skeleton = source.skeleton;
        model.skins.push_back(std::move(skin));
    }
    check_joint_indices(reader, model);
}

} // namespace hachure::assets
