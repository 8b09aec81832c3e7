#include <hachure/runtime/assets/mesh_builder.h>
#include <hachure/runtime/assets/mesh_bytes.h>
#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/assets/obj_data.h>
#include <hachure/runtime/assets/obj_material.h>
#include <hachure/runtime/assets/text_scanner.h>

#include <map>

namespace hachure::assets {
namespace {

/// Numbers the distinct corners of each primitive (open addressing, at most half full).
class CornerTable {
public:
    /// The vertex for a corner, which is `next` when it is new.
    std::uint32_t find_or_add(const ObjCorner& corner, std::uint32_t primitive, std::uint32_t next) {
        if (2 * used_ >= slots_.size()) grow();
        Slot& slot = slots_[locate(corner, primitive)];
        if (slot.vertex == empty) {
            slot = {corner, primitive, next};
            ++used_;
        }
        return slot.vertex;
    }

private:
    static constexpr std::uint32_t empty = 0xffffffffu;
    struct Slot {
        ObjCorner corner{};
        std::uint32_t primitive = 0, vertex = empty;
    };

    static std::size_t hash(const ObjCorner& c, std::uint32_t primitive) {
        std::uint64_t h = (static_cast<std::uint64_t>(c.v) << 32 | c.t) * 0x9e3779b97f4a7c15u;
        h = (h ^ (h >> 29) ^ (static_cast<std::uint64_t>(primitive) << 32 | c.n)) * 0xbf58476d1ce4e5b9u;
        return h ^ (h >> 32);
    }

    [[nodiscard]] std::size_t locate(const ObjCorner& corner, std::uint32_t primitive) const {
        std::size_t i = hash(corner, primitive) & (slots_.size() - 1);
        while (slots_[i].vertex != empty && (slots_[i].corner != corner || slots_[i].primitive != primitive))
            i = (i + 1) & (slots_.size() - 1);
        return i;
    }

    void grow() {
        std::vector<Slot> old(std::max<std::size_t>(1024, slots_.size() * 4));
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.vertex != empty) slots_[locate(slot.corner, slot.primitive)] = slot;
    }

    std::vector<Slot> slots_;
    std::size_t used_ = 0;
};

/// Turns the faces of an OBJ file into primitives: one for every pair of object and material in use.
class ObjBuilder {
public:
    ObjBuilder(const TextScanner& scan, const ObjData& data, WarningList& warnings)
        : scan_(scan), data_(data), warnings_(warnings) {}

    std::vector<std::pair<std::uint32_t, Primitive>> run() {
        for (std::size_t r = 0; r < data_.runs.size(); ++r) {
            const ObjRun& run = data_.runs[r];
            const std::size_t end = r + 1 < data_.runs.size() ? data_.runs[r + 1].first_face : data_.faces.size();
            if (run.first_face == end) continue;
            const std::uint32_t primitive = primitive_of(run);
            for (std::size_t f = run.first_face; f < end; ++f) add_face(f, primitive);
        }
        cutter_.report(warnings_);
        return std::move(primitives_);
    }

private:
    std::uint32_t primitive_of(const ObjRun& run) {
        if (primitives_.size() == max_obj_parts) {
            warnings_.add_count("runs of a material are more than can be kept apart");
            return static_cast<std::uint32_t>(primitives_.size() - 1);
        }
        const auto [at, is_new] =
            index_.try_emplace({run.object, run.material}, static_cast<std::uint32_t>(primitives_.size()));
        if (is_new) primitives_.emplace_back(run.object, Primitive{}).second.material = run.material;
        return at->second;
    }

    void add_face(std::size_t face, std::uint32_t primitive) {
        const std::size_t first = data_.faces[face].first_corner;
        const std::size_t end =
            face + 1 < data_.faces.size() ? data_.faces[face + 1].first_corner : data_.corners.size();
        Primitive& out = primitives_[primitive].second;
        polygon_.clear();
        for (std::size_t c = first; c < end; ++c) {
            const ObjCorner& corner = data_.corners[c];
            check(corner.v, data_.positions.size(), face);
            if (corner.t != ObjCorner::absent) check(corner.t, data_.texcoords.size(), face);
            if (corner.n != ObjCorner::absent) check(corner.n, data_.normals.size(), face);
            const auto next = static_cast<std::uint32_t>(out.positions.size());
            polygon_.push_back(vertices_.find_or_add(corner, primitive, next));
            if (polygon_.back() == next) add_vertex(corner, out);
        }
        cutter_.add(out.positions, polygon_, out.indices);
    }

    void check(std::uint32_t index, std::size_t size, std::size_t face) const {
        if (index >= size) scan_.fail_at("index out of range", data_.faces[face].offset);
    }

    /// An attribute that starts late is filled up: a normal without direction makes the primitive drop its normals.
    void add_vertex(const ObjCorner& corner, Primitive& out) const {
        const std::size_t before = out.positions.size();
        out.positions.push_back(data_.positions[corner.v]);
        if (!data_.colors.empty()) out.colors.emplace_back(data_.colors[corner.v], 1.0f);
        if (corner.t != ObjCorner::absent || !out.texcoords[0].empty()) {
            out.texcoords[0].resize(before, glm::vec2(0.0f));
            out.texcoords[0].push_back(corner.t != ObjCorner::absent ? data_.texcoords[corner.t] : glm::vec2(0.0f));
        }
        if (corner.n != ObjCorner::absent || !out.normals.empty()) {
            out.normals.resize(before, glm::vec3(0.0f));
            out.normals.push_back(corner.n != ObjCorner::absent ? data_.normals[corner.n] : glm::vec3(0.0f));
        }
    }

    const TextScanner& scan_;
    const ObjData& data_;
    WarningList& warnings_;
    std::map<std::pair<std::uint32_t, std::int32_t>, std::uint32_t> index_;
    std::vector<std::pair<std::uint32_t, Primitive>> primitives_; ///< with their objects
    CornerTable vertices_;
    FaceCutter cutter_;
    std::vector<std::uint32_t> polygon_; // scratch
};

} // namespace

Model read_obj(const std::filesystem::path& file) {
    const MeshBytes bytes = read_mesh_bytes(file);
    WarningList warnings;
    const ObjData data = parse_obj(file, bytes.text(), warnings);
    auto primitives = ObjBuilder(TextScanner(file, bytes.text()), data, warnings).run();
    std::erase_if(primitives, [](const auto& p) { return p.second.indices.empty(); });
    if (primitives.empty()) throw Error(file.string(), "no triangles");

    Model model;
    read_obj_materials(file, data.libraries, data.materials, model, warnings);
    std::map<std::uint32_t, std::vector<Primitive>> by_object;
    for (auto& [object, primitive] : primitives) {
        tidy_attributes(primitive, warnings);
        by_object[object].push_back(std::move(primitive));
    }
    for (auto& [object, parts] : by_object) add_mesh(model, data.objects[object], std::move(parts));
    model.warnings = warnings.lines();
    return model;
}

} // namespace hachure::assets
