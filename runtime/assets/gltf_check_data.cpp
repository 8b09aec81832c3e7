#include <hachure/runtime/assets/gltf_check_data.h>

#include <string>
#include <vector>

namespace hachure::assets {
namespace {

constexpr std::size_t max_size = (std::size_t{1} << 31) - 1;

constexpr std::size_t component_byte = 5120;  // BYTE, UNSIGNED_BYTE, SHORT, UNSIGNED_SHORT follow
constexpr std::size_t component_uint = 5125;  // UNSIGNED_INT
constexpr std::size_t component_float = 5126; // FLOAT
constexpr std::size_t component_int = 5124;   // no component type of glTF

std::vector<std::size_t> check_buffers(const JsonPlace& root) {
    std::vector<std::size_t> lengths;
    root.each("buffers", [&](const JsonPlace& buffer) {
        buffer.string("uri");
        lengths.push_back(buffer.integer("byteLength", 0, max_size, Need::required));
    });
    return lengths;
}

// The range [byteOffset, byteOffset + byteLength) lies in the buffer.
void check_range(const JsonPlace& place, const std::vector<std::size_t>& lengths) {
    const std::size_t buffer = place.index("buffer", lengths.size(), Need::required);
    const std::size_t offset = place.integer("byteOffset", 0, max_size);
    const std::size_t length = place.integer("byteLength", 0, max_size, Need::required);
    if (offset > lengths[buffer] || length > lengths[buffer] - offset) place.fail("ends beyond its buffer");
}

void check_buffer_views(const JsonPlace& root, const std::vector<std::size_t>& lengths) {
    root.each("bufferViews", [&](const JsonPlace& view) {
        check_range(view, lengths);
        view.integer("byteStride", 0, 252); // some writers say 0 for "packed"
        view.extension("EXT_meshopt_compression", [&](const JsonPlace& compression) {
            check_range(compression, lengths);
            compression.integer("byteStride", 1, 256, Need::required);
            compression.integer("count", 0, max_size, Need::required);
            compression.choice("mode", {"ATTRIBUTES", "TRIANGLES", "INDICES"}, Need::required);
            compression.choice("filter", {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"}, Need::optional);
        });
    });
}

std::size_t check_component_type(const JsonPlace& place) {
    const std::size_t type = place.integer("componentType", component_byte, component_float, Need::required);
    if (type == component_int) place.fail_at("componentType", "is not a component type of glTF");
    return type;
}

void check_sparse(const JsonPlace& sparse, std::size_t accessor_count, const GltfCounts& counts) {
    sparse.integer("count", 0, accessor_count, Need::required);
    const auto values = [&](const JsonPlace& place) {
        place.index("bufferView", counts.buffer_views, Need::required);
        place.integer("byteOffset", 0, max_size);
    };
    sparse.object(
        "indices",
        [&](const JsonPlace& indices) {
            values(indices);
            const std::size_t type = check_component_type(indices);
            if (type != component_byte + 1 && type != component_byte + 3 && type != component_uint)
                indices.fail_at("componentType", "must be an unsigned integer");
        },
        Need::required);
    sparse.object("values", values, Need::required);
}

void check_accessors(const JsonPlace& root, const GltfCounts& counts) {
    root.each("accessors", [&](const JsonPlace& accessor) {
        accessor.index("bufferView", counts.buffer_views);
        accessor.integer("byteOffset", 0, max_size);
        check_component_type(accessor);
        accessor.boolean("normalized");
        const std::size_t count = accessor.integer("count", 0, max_size, Need::required);
        accessor.choice("type", {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}, Need::required);
        accessor.object("sparse", [&](const JsonPlace& sparse) { check_sparse(sparse, count, counts); });
    });
}

void check_meshes(const JsonPlace& root, const GltfCounts& counts) {
    const auto accessors = [&](const JsonPlace& attributes) { attributes.index_members(counts.accessors); };
    root.each("meshes", [&](const JsonPlace& mesh) {
        mesh.string("name");
        mesh.numbers("weights", 0);
        mesh.each(
            "primitives",
            [&](const JsonPlace& primitive) {
                primitive.object("attributes", accessors, Need::required);
                primitive.index("indices", counts.accessors);
                primitive.index("material", counts.materials);
                primitive.integer("mode", 0, 1'000);
                primitive.each("targets", accessors);
            },
            Need::required);
    });
}

void check_skins(const JsonPlace& root, const GltfCounts& counts) {
    root.each("skins", [&](const JsonPlace& skin) {
        skin.string("name");
        skin.indices("joints", counts.nodes, Need::required);
        skin.index("inverseBindMatrices", counts.accessors);
        skin.index("skeleton", counts.nodes);
    });
}

void check_target(const JsonPlace& target, const GltfCounts& counts) {
    target.index("node", counts.nodes);
    target.choice("path", {"translation", "rotation", "scale", "weights", "pointer"}, Need::required);
    target.extension("KHR_animation_pointer",
                     [](const JsonPlace& pointer) { pointer.string("pointer", Need::required); });
}

void check_animations(const JsonPlace& root, const GltfCounts& counts) {
    root.each("animations", [&](const JsonPlace& animation) {
        animation.string("name");
        const std::size_t samplers = animation.array_size("samplers");
        animation.each("samplers", [&](const JsonPlace& sampler) {
            sampler.index("input", counts.accessors, Need::required);
            sampler.index("output", counts.accessors, Need::required);
            sampler.choice("interpolation", {"LINEAR", "STEP", "CUBICSPLINE"}, Need::optional);
        });
        animation.each("channels", [&](const JsonPlace& channel) {
            channel.index("sampler", samplers, Need::required);
            channel.object(
                "target", [&](const JsonPlace& target) { check_target(target, counts); }, Need::required);
        });
    });
}

} // namespace

void check_gltf_data(const JsonPlace& root, const GltfCounts& counts) {
    check_buffer_views(root, check_buffers(root));
    check_accessors(root, counts);
    check_meshes(root, counts);
    check_skins(root, counts);
    check_animations(root, counts);
}

} // namespace hachure::assets
