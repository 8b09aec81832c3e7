#include <hachure/runtime/assets/mesh_builder.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/triangulate.h>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace hachure::assets {
namespace {

float srgb_curve(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }

bool normalize_all(std::vector<glm::vec3>& normals) {
    for (glm::vec3& n : normals) {
        const glm::dvec3 wide(n);
        const double length = std::sqrt(glm::dot(wide, wide));
        if (!(length > 0.0) || !std::isfinite(length)) return false;
        n = glm::vec3(wide / length);
    }
    return true;
}

} // namespace

void FaceCutter::add_polygon(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners,
                             std::vector<std::uint32_t>& indices) {
    polygon_.clear();
    for (const std::uint32_t v : corners)
        if (polygon_.empty() || polygon_.back() != v) polygon_.push_back(v);
    while (polygon_.size() > 1 && polygon_.back() == polygon_.front()) polygon_.pop_back();
    if (polygon_.size() < 3) {
        ++dropped_;
        return;
    }
    points_.clear();
    for (const std::uint32_t v : polygon_) points_.push_back(positions[v]);
    cut_.clear();
    if (!geometry::triangulate_polygon(points_, cut_)) ++coarse_;
    for (const std::uint32_t i : cut_) indices.push_back(polygon_[i]);
}

void FaceCutter::report(WarningList& warnings) const {
    if (dropped_ > 0) warnings.add_count("faces with fewer than three corners are dropped", dropped_);
    if (repeated_ > 0) warnings.add_count("triangles repeat a vertex", repeated_);
    if (coarse_ > 0) warnings.add_count("concave polygons are too large to be cut exactly", coarse_);
}

float linear_from_srgb(float value) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = srgb_curve(static_cast<float>(i) / 255.0f);
        return t;
    }();
    if (!(value > 0.0f) || !std::isfinite(value)) return 0.0f;
    // Most colours come from bytes: those cost no power.
    const float scaled = std::round(value * 255.0f);
    return scaled <= 255.0f && scaled / 255.0f == value ? table[static_cast<std::size_t>(scaled)] : srgb_curve(value);
}

void tidy_attributes(Primitive& primitive, WarningList& warnings) {
    if (!normalize_all(primitive.normals)) {
        primitive.normals.clear();
        warnings.add_count("primitives have unusable normals, which are computed instead");
    }
    for (glm::vec2& t : primitive.texcoords[0]) {
        if (std::isfinite(t.x) && std::isfinite(t.y)) continue;
        t = glm::vec2(0.0f);
        warnings.add_count("texture coordinates are not finite, and are set to 0");
    }
    for (glm::vec4& c : primitive.colors) {
        const float alpha = c.w >= 0.0f && std::isfinite(c.w) ? c.w : 1.0f;
        c = {linear_from_srgb(c.x), linear_from_srgb(c.y), linear_from_srgb(c.z), alpha};
    }
}

void add_mesh(Model& model, std::string name, std::vector<Primitive> primitives) {
    if (model.scenes.empty()) model.scenes.emplace_back();
    Node node;
    node.name = name;
    node.mesh = static_cast<std::int32_t>(model.meshes.size());
    model.scenes[0].roots.push_back(static_cast<std::int32_t>(model.nodes.size()));
    model.nodes.push_back(std::move(node));
    model.meshes.push_back({std::move(name), std::move(primitives), {}});
}

Model make_model(const std::filesystem::path& file, Primitive primitive, WarningList warnings) {
    if (primitive.indices.empty()) throw Error(file.string(), "no triangles");
    tidy_attributes(primitive, warnings);
    Model model;
    model.warnings = warnings.lines();
    std::vector<Primitive> primitives;
    primitives.push_back(std::move(primitive));
    add_mesh(model, model_name(file), std::move(primitives));
    return model;
}

std::string model_name(const std::filesystem::path& file) {
    const std::filesystem::path name = file.filename();
    return (name.extension() == ".gz" ? name.stem() : name).stem().string();
}

} // namespace hachure::assets
