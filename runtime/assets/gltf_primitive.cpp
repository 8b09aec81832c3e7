#include <hachure/runtime/assets/gltf_numbers.h>
#include <hachure/runtime/assets/gltf_reader.h>
#include <hachure/runtime/assets/gltf_triangles.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hachure::assets {
namespace {

/// Reads the attributes of one primitive into `out`.
class PrimitiveReader {
public:
    PrimitiveReader(const GltfReader& reader, GltfPrimitiveAt at)
        : reader_(reader), at_(at), source_(reader.document.model->meshes[at.mesh].primitives[at.primitive]) {}

    std::optional<Primitive> read() {
        const std::optional<TriangleMode> mode = triangle_mode();
        if (!mode || !read_positions() || !read_indices(*mode)) return std::nullopt;
        read_normals();
        read_tangents();
        read_texcoords();
        read_colors();
        read_influences();
        report_other_attributes();
        out_.material = source_.material;
        read_morph_targets(reader_, at_, out_);
        return std::move(out_);
    }

private:
    std::optional<TriangleMode> triangle_mode() {
        switch (source_.mode) {
        case TINYGLTF_MODE_TRIANGLES:
            return TriangleMode::list;
        case TINYGLTF_MODE_TRIANGLE_STRIP:
            return TriangleMode::strip;
        case TINYGLTF_MODE_TRIANGLE_FAN:
            return TriangleMode::fan;
        case TINYGLTF_MODE_POINTS:
        case TINYGLTF_MODE_LINE:
        case TINYGLTF_MODE_LINE_LOOP:
        case TINYGLTF_MODE_LINE_STRIP:
            warn("points and lines are skipped");
            return std::nullopt;
        default:
            warn("primitives of an unknown mode are skipped");
            return std::nullopt;
        }
    }

    bool read_positions() {
        const int accessor = find("POSITION");
        if (accessor < 0) return refuse("primitives without positions are skipped");
        require(accessor, reader_.accessors.shape(accessor).is_vector(3), "POSITION must be VEC3");
        out_.positions = reader_.accessors.vectors<glm::vec3>(accessor);
        if (!all_finite(components_of(out_.positions)))
            reader_.document.fail("has a position that is not finite", accessor_pointer(accessor));
        if (out_.positions.empty()) return refuse("primitives without vertices are skipped");
        return true;
    }

    bool read_indices(TriangleMode mode) {
        std::vector<std::uint32_t> vertices = source_.indices >= 0 ? index_accessor() : every_vertex();
        if (mode == TriangleMode::list && vertices.size() % 3 != 0)
            warn("vertices that do not make a whole triangle are skipped");
        if (mode != TriangleMode::list)
            reader_.accessors.spend_elements(vertices.size(), 3 * sizeof(std::uint32_t), where());
        out_.indices = triangle_list(mode, std::move(vertices));
        return !out_.indices.empty() || refuse("primitives without a whole triangle are skipped");
    }

    std::vector<std::uint32_t> every_vertex() {
        reader_.accessors.spend_elements(out_.positions.size(), sizeof(std::uint32_t), where());
        std::vector<std::uint32_t> vertices(out_.positions.size());
        std::iota(vertices.begin(), vertices.end(), 0u);
        return vertices;
    }

    std::vector<std::uint32_t> index_accessor() {
        const AccessorShape shape = reader_.accessors.shape(source_.indices);
        const bool is_unsigned =
            shape.type == ComponentType::u8 || shape.type == ComponentType::u16 || shape.type == ComponentType::u32;
        require(source_.indices, shape.is_vector(1) && is_unsigned, "indices must be unsigned integer scalars");
        std::vector<std::uint32_t> vertices = reader_.accessors.integers(source_.indices);
        // The largest value of the type would restart a strip: glTF 2.0 forbids it (section 3.7.2.1).
        const std::uint32_t restart = shape.type == ComponentType::u8    ? 0xffu
                                      : shape.type == ComponentType::u16 ? 0xffffu
                                                                         : 0xffffffffu;
        for (const std::uint32_t vertex : vertices) {
            if (vertex == restart)
                reader_.document.fail("has a primitive restart among its indices", accessor_pointer(source_.indices));
            if (vertex >= out_.positions.size())
                reader_.document.fail(fmt::format("has the index {} to {} vertices", vertex, out_.positions.size()),
                                      accessor_pointer(source_.indices));
        }
        return vertices;
    }

    void read_normals() {
        const int accessor = find_matching("NORMAL", 3, 3);
        if (accessor < 0) return;
        auto normals = reader_.accessors.vectors<glm::vec3>(accessor);
        if (std::all_of(normals.begin(), normals.end(), [](glm::vec3& n) { return make_unit(n); }))
            out_.normals = std::move(normals);
        else
            warn("normals that are zero or not finite: computed ones take their place");
    }

    void read_tangents() {
        const int accessor = find_matching("TANGENT", 4, 4);
        if (accessor < 0) return;
        auto tangents = reader_.accessors.vectors<glm::vec4>(accessor);
        const auto make_tangent = [](glm::vec4& tangent) {
            glm::vec3 direction(tangent);
            if (!make_unit(direction) || !std::isfinite(tangent.w)) return false;
            tangent = glm::vec4(direction, tangent.w < 0.0f ? -1.0f : 1.0f);
            return true;
        };
        if (std::all_of(tangents.begin(), tangents.end(), make_tangent))
            out_.tangents = std::move(tangents);
        else
            warn("tangents that are zero or not finite are dropped");
    }

    void read_texcoords() {
        for (int set = 0; set < 2; ++set) {
            const int accessor = find_matching(fmt::format("TEXCOORD_{}", set), 2, 2);
            if (accessor < 0) continue;
            out_.texcoords[set] = reader_.accessors.vectors<glm::vec2>(accessor);
            if (zero_non_finite(components_of(out_.texcoords[set])))
                warn("texture coordinates that are not finite become zero");
        }
    }

    void read_colors() {
        const int accessor = find_matching("COLOR_0", 3, 4);
        if (accessor < 0) return;
        if (reader_.accessors.shape(accessor).is_vector(4)) {
            out_.colors = reader_.accessors.vectors<glm::vec4>(accessor);
        } else {
            reader_.accessors.spend_elements(out_.positions.size(), sizeof(glm::vec4), accessor_pointer(accessor));
            out_.colors.reserve(out_.positions.size());
            for (const glm::vec3& color : reader_.accessors.vectors<glm::vec3>(accessor))
                out_.colors.emplace_back(color, 1.0f);
        }
        if (zero_non_finite(components_of(out_.colors))) warn("colours that are not finite become zero");
    }

    // JOINTS_n and WEIGHTS_n come in pairs, the second only after the first.
    void read_influences() {
        for (int set = 0; set < 2; ++set) {
            const int joints = find_influence("JOINTS", set);
            const int weights = find_influence("WEIGHTS", set);
            if (joints < 0 && weights < 0) return;
            if (joints < 0 || weights < 0)
                return warn("joints without weights, or weights without joints, are dropped");
            read_joints(joints, out_.joints[set]);
            out_.weights[set] = reader_.accessors.vectors<glm::vec4>(weights);
            if (zero_non_finite(components_of(out_.weights[set]))) warn("skin weights that are not finite become zero");
        }
    }

    // Without them the mesh would not deform, so sizes that do not fit are no matter for a repair.
    int find_influence(std::string_view name, int set) {
        const int accessor = find(fmt::format("{}_{}", name, set));
        if (accessor < 0) return -1;
        const AccessorShape shape = reader_.accessors.shape(accessor);
        require(accessor, shape.is_vector(4), fmt::format("{}_{} must be VEC4", name, set));
        require(accessor, shape.count == out_.positions.size(),
                fmt::format("{}_{} must have one element per vertex", name, set));
        return accessor;
    }

    void read_joints(int accessor, std::vector<glm::u16vec4>& joints) {
        const AccessorShape shape = reader_.accessors.shape(accessor);
        require(accessor, shape.type == ComponentType::u8 || shape.type == ComponentType::u16,
                "joints must be unsigned bytes or shorts");
        const std::vector<std::uint32_t> values = reader_.accessors.integers(accessor);
        joints.resize(shape.count);
        for (std::size_t i = 0; i < values.size(); ++i)
            joints[i / 4][static_cast<int>(i % 4)] = static_cast<std::uint16_t>(values[i]);
    }

    void report_other_attributes() {
        for (const auto& [name, accessor] : source_.attributes) {
            const std::size_t digits = name.find_first_of("0123456789");
            const std::string kind = name.substr(0, digits);
            const bool first_two =
                digits != std::string::npos && (name.substr(digits) == "0" || name.substr(digits) == "1");
            if (kind == "TEXCOORD_" && !first_two) warn("texture coordinates beyond the second set are skipped");
            if (kind == "COLOR_" && name != "COLOR_0") warn("vertex colours beyond the first set are skipped");
            if ((kind == "JOINTS_" || kind == "WEIGHTS_") && !first_two)
                warn("skin influences beyond eight are skipped");
        }
    }

    static bool make_unit(glm::vec3& vector) {
        // Scaled first: the square of a component may leave the range of a float.
        const float largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
        if (!(largest > 0.0f && largest <= std::numeric_limits<float>::max())) return false;
        vector = glm::normalize(vector / largest);
        return std::isfinite(vector.x + vector.y + vector.z);
    }

    [[nodiscard]] int find(const std::string& name) const {
        const auto it = source_.attributes.find(name);
        return it != source_.attributes.end() ? it->second : -1;
    }

    // An attribute that may be missing: -1, with a warning, when it is there but has another count than the positions.
    int find_matching(const std::string& name, int least, int most) {
        const int accessor = find(name);
        if (accessor < 0) return -1;
        const AccessorShape shape = reader_.accessors.shape(accessor);
        require(accessor, shape.columns == 1 && shape.rows >= least && shape.rows <= most,
                fmt::format("{} has the wrong type", name));
        if (shape.count == out_.positions.size()) return accessor;
        warn(fmt::format("{} without one element per vertex is dropped", name));
        return -1;
    }

    void require(int accessor, bool condition, std::string_view fault) const {
        if (!condition) reader_.document.fail(fault, accessor_pointer(accessor));
    }

    void warn(std::string_view text) const { reader_.warnings.add(text, where()); }

    bool refuse(std::string_view text) const {
        warn(text);
        return false;
    }

    [[nodiscard]] std::string where() const { return fmt::format("/meshes/{}/primitives/{}", at_.mesh, at_.primitive); }

    const GltfReader& reader_;
    GltfPrimitiveAt at_;
    const tinygltf::Primitive& source_;
    Primitive out_;
};

} // namespace

std::optional<Primitive> read_primitive(const GltfReader& reader, GltfPrimitiveAt at) {
    return PrimitiveReader(reader, at).read();
}

} // namespace hachure::assets
