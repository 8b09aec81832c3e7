#include <hachure/runtime/assets/mesh_builder.h>
#include <hachure/runtime/assets/mesh_bytes.h>
#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/assets/ply_source.h>

#include <algorithm>
#include <array>

namespace hachure::assets {
namespace {

/// What a property of a vertex means: a component of an attribute.
enum Component : std::size_t { x, y, z, nx, ny, nz, red, green, blue, alpha, s, t, components };

Component component_of(std::string_view name) {
    static constexpr std::pair<std::string_view, Component> names[] = {{"x", x},
                                                                       {"y", y},
                                                                       {"z", z},
                                                                       {"nx", nx},
                                                                       {"ny", ny},
                                                                       {"nz", nz},
                                                                       {"red", red},
                                                                       {"green", green},
                                                                       {"blue", blue},
                                                                       {"alpha", alpha},
                                                                       {"r", red},
                                                                       {"g", green},
                                                                       {"b", blue},
                                                                       {"a", alpha},
                                                                       {"diffuse_red", red},
                                                                       {"diffuse_green", green},
                                                                       {"diffuse_blue", blue},
                                                                       {"diffuse_alpha", alpha},
                                                                       {"s", s},
                                                                       {"t", t},
                                                                       {"u", s},
                                                                       {"v", t},
                                                                       {"texture_u", s},
                                                                       {"texture_v", t},
                                                                       {"texture_s", s},
                                                                       {"texture_t", t}};
    for (const auto& [known, component] : names)
        if (known == name) return component;
    return components;
}

/// What makes a colour of this type lie in [0, 1].
float color_scale(PlyType type) {
    return type == PlyType::u8 ? 1.0f / 255.0f : type == PlyType::u16 ? 1.0f / 65535.0f : 1.0f;
}

template <class Source> class PlyReader {
public:
    PlyReader(Source source, const PlyHeader& header, WarningList& warnings)
        : source_(std::move(source)), header_(header), warnings_(warnings) {}

    Primitive run() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element, &PlyReader::add_face);
            else if (element.name == "tristrips")
                read_faces(element, &PlyReader::add_strip);
            else
                skip_element(element);
        }
        cutter_.report(warnings_);
        return std::move(out_);
    }

private:
    void skip_property(const PlyProperty& property) {
        const std::size_t count = property.is_list ? list_size(property) : 1;
        source_.skip(property.type, count);
    }

    void skip_element(const PlyElement& element) {
        warnings_.add_name("elements not read", element.name);
        if (element.properties.empty()) return;
        for (std::uint64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) skip_property(property);
    }

    /// A count that the rest of the file can hold.
    std::size_t list_size(const PlyProperty& property) {
        const std::int64_t count = source_.read_integer(property.count_type);
        if (count < 0) source_.fail("a list with a negative count");
        if (!source_.holds(property.type, static_cast<std::uint64_t>(count)))
            source_.fail("truncated: a list claims more than the file can hold");
        return static_cast<std::size_t>(count);
    }

    void read_vertices(const PlyElement& element) {
        std::vector<Component> meaning;
        std::array<bool, components + 1> has{};
        for (const PlyProperty& property : element.properties) {
            Component c = property.is_list ? components : component_of(property.name);
            if (c != components && has[c]) c = components; // of two spellings the first one counts
            if (c == components) warnings_.add_name("vertex properties not read", property.name);
            has[c] = true;
            meaning.push_back(c);
        }
        if (!has[x] || !has[y] || !has[z]) source_.fail("vertices without x, y and z");
        if (!out_.positions.empty()) source_.fail("a second list of vertices");
        const bool normals = has[nx] && has[ny] && has[nz], colors = has[red] && has[green] && has[blue];
        const bool texcoords = has[s] && has[t];
        const auto count = static_cast<std::size_t>(element.count); // the header checked it against the file
        out_.positions.reserve(count);
        if (normals) out_.normals.reserve(count);
        if (colors) out_.colors.reserve(count);
        if (texcoords) out_.texcoords[0].reserve(count);

        std::array<float, components + 1> row{};
        row[alpha] = 1.0f;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t p = 0; p < meaning.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (meaning[p] == components)
                    skip_property(property);
                else
                    row[meaning[p]] = source_.read_float(property.type) *
                                      (meaning[p] >= red && meaning[p] <= alpha ? color_scale(property.type) : 1.0f);
            }
            out_.positions.emplace_back(row[x], row[y], row[z]);
            if (!is_finite(out_.positions.back())) source_.fail("a position is not finite");
            if (normals) out_.normals.emplace_back(row[nx], row[ny], row[nz]);
            if (colors) out_.colors.emplace_back(row[red], row[green], row[blue], row[alpha]);
            if (texcoords) out_.texcoords[0].emplace_back(row[s], 1.0f - row[t]); // PLY counts t from the bottom
        }
    }

    using AddList = void (PlyReader::*)(const PlyProperty& list, std::size_t count);

    void read_faces(const PlyElement& element, AddList add) {
        if (element.count == 0) return;
        const auto indices = std::ranges::find_if(element.properties, [&](const PlyProperty& p) {
            return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
        });
        if (indices == element.properties.end()) source_.fail("faces without a list of vertices");
        if (out_.positions.empty()) source_.fail("faces before the vertices");
        for (const PlyProperty& property : element.properties)
            if (&property != &*indices) warnings_.add_name("face properties not read", property.name);
        if (add == &PlyReader::add_face) out_.indices.reserve(3 * static_cast<std::size_t>(element.count));
        for (std::uint64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) {
                if (&property == &*indices)
                    (this->*add)(property, list_size(property));
                else
                    skip_property(property);
            }
    }

    std::uint32_t checked(std::int64_t index) const {
        if (index < 0 || static_cast<std::uint64_t>(index) >= out_.positions.size()) source_.fail("index out of range");
        return static_cast<std::uint32_t>(index);
    }

    void add_face(const PlyProperty& list, std::size_t count) {
        polygon_.resize(count);
        for (std::uint32_t& v : polygon_) v = checked(source_.read_integer(list.type));
        cutter_.add(out_.positions, polygon_, out_.indices);
    }

    /// Strips follow each other in the list with -1 between them. Every second triangle has its winding turned over;
    /// triangles that repeat a vertex only move the strip on.
    void add_strip(const PlyProperty& list, std::size_t count) {
        std::uint32_t a = 0, b = 0;
        std::size_t length = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t value = source_.read_integer(list.type);
            if (value == -1) {
                length = 0;
                continue;
            }
            const std::uint32_t c = checked(value);
            if (++length >= 3 && a != b && b != c && c != a) {
                const bool turned = length % 2 == 0;
                out_.indices.insert(out_.indices.end(), {turned ? b : a, turned ? a : b, c});
            }
            a = b;
            b = c;
        }
    }

    Source source_;
    const PlyHeader& header_;
    WarningList& warnings_;
    Primitive out_;
    FaceCutter cutter_;
    std::vector<std::uint32_t> polygon_; // scratch
};

template <class Source>
Primitive read_body(const std::filesystem::path& file, std::string_view text, const PlyHeader& header,
                    WarningList& warnings) {
    return PlyReader<Source>(Source(file, text, header.body), header, warnings).run();
}

} // namespace

Model read_ply(const std::filesystem::path& file) {
    static_assert(std::endian::native == std::endian::little, "binary values are swapped for a little-endian machine");
    const MeshBytes bytes = read_mesh_bytes(file);
    const PlyHeader header = parse_ply_header(file, bytes.text());
    WarningList warnings;
    Primitive primitive = header.format == PlyFormat::ascii
                              ? read_body<PlyTextSource>(file, bytes.text(), header, warnings)
                          : header.format == PlyFormat::little_endian
                              ? read_body<PlyBinarySource<false>>(file, bytes.text(), header, warnings)
                              : read_body<PlyBinarySource<true>>(file, bytes.text(), header, warnings);
    return make_model(file, std::move(primitive), std::move(warnings));
}

} // namespace hachure::assets
