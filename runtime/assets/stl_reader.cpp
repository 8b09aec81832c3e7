#include <hachure/runtime/assets/mesh_builder.h>
#include <hachure/runtime/assets/mesh_bytes.h>
#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/assets/text_scanner.h>
#include <hachure/runtime/geometry/weld.h>

#include <glm/geometric.hpp>

#include <cstring>

namespace hachure::assets {
namespace {

constexpr std::size_t stl_header_bytes = 84, stl_facet_bytes = 50;

/// The triangles of an STL file, each with three positions of its own.
struct Facets {
    std::vector<glm::vec3> positions;
    std::size_t opposed = 0; ///< facet normals against the winding

    void add(const glm::vec3& normal, const glm::vec3 (&corners)[3]) {
        positions.insert(positions.end(), std::begin(corners), std::end(corners));
        const glm::vec3 winding = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (is_finite(normal) && glm::dot(winding, normal) < 0.0f) ++opposed;
    }
};

std::uint32_t facet_count(std::string_view bytes) {
    std::uint32_t count = 0;
    if (bytes.size() >= stl_header_bytes)
        std::memcpy(&count, bytes.data() + stl_header_bytes - sizeof(count), sizeof(count));
    return count;
}

/// A text starts with "solid", but so do the headers of some binary files: those have exactly the size they claim.
bool is_text(std::string_view bytes) {
    const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    const std::string_view word = bytes.substr(first, 5);
    if (word != "solid" && word != "SOLID") return false;
    return bytes.size() != stl_header_bytes + stl_facet_bytes * static_cast<std::uint64_t>(facet_count(bytes)) ||
           bytes.size() < stl_header_bytes;
}

Facets read_binary(const std::filesystem::path& file, std::string_view bytes) {
    if (bytes.size() < stl_header_bytes) throw Error(file.string(), "truncated, or not an STL file", "byte 0");
    const std::size_t count = facet_count(bytes);
    if (count > (bytes.size() - stl_header_bytes) / stl_facet_bytes)
        throw Error(file.string(), "truncated: it claims " + std::to_string(count) + " facets, more than it can hold",
                    "byte 80");
    Facets facets;
    facets.positions.reserve(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        glm::vec3 values[4]; // normal, corners
        static_assert(sizeof(values) == 48);
        const std::size_t at = stl_header_bytes + i * stl_facet_bytes;
        std::memcpy(values, bytes.data() + at, sizeof(values));
        if (!is_finite(values[1]) || !is_finite(values[2]) || !is_finite(values[3]))
            throw Error(file.string(), "a position is not finite", "byte " + std::to_string(at));
        facets.add(values[0], {values[1], values[2], values[3]});
    }
    return facets;
}

bool is_word(std::string_view word, std::string_view lower) {
    return std::ranges::equal(word, lower,
                              [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a + 32 == b); });
}

class TextReader {
public:
    TextReader(const std::filesystem::path& file, std::string_view text) : scan_(file, text) {}

    Facets run() {
        for (scan_.skip_space(); !scan_.at_end(); scan_.skip_space()) {
            const std::string_view word = scan_.word();
            if (is_word(word, "solid") || is_word(word, "endsolid"))
                scan_.skip_line(); // the name of a solid may hold anything
            else if (is_word(word, "facet"))
                facet();
            else
                scan_.fail("expected a facet");
        }
        return std::move(facets_);
    }

private:
    void expect(std::string_view lower) {
        scan_.skip_space();
        if (!is_word(scan_.word(), lower))
            scan_.fail(scan_.at_end() ? "truncated" : "expected \"" + std::string(lower) + "\"");
    }

    glm::vec3 vector() {
        glm::vec3 v;
        for (float* value : {&v.x, &v.y, &v.z}) {
            scan_.skip_space();
            if (!scan_.read(*value) || !scan_.at_word_end())
                scan_.fail(scan_.at_end() ? "truncated" : "expected a number");
        }
        return v;
    }

    void facet() {
        expect("normal");
        const glm::vec3 normal = vector();
        expect("outer");
        expect("loop");
        glm::vec3 corners[3];
        for (glm::vec3& corner : corners) {
            expect("vertex");
            corner = vector();
            if (!is_finite(corner)) scan_.fail("a position is not finite");
        }
        expect("endloop");
        expect("endfacet");
        facets_.add(normal, corners);
    }

    TextScanner scan_;
    Facets facets_;
};

/// One vertex for each position, in the order of their first use.
Primitive weld(const std::vector<glm::vec3>& corners, WarningList& warnings) {
    const std::vector<std::uint32_t> first = geometry::weld_positions(corners);
    Primitive primitive;
    FaceCutter cutter;
    std::vector<std::uint32_t> vertex(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        vertex[i] = first[i] == i ? static_cast<std::uint32_t>(primitive.positions.size()) : vertex[first[i]];
        if (first[i] == i) primitive.positions.push_back(corners[i]);
        if (i % 3 == 2) cutter.add(primitive.positions, std::span(vertex).subspan(i - 2, 3), primitive.indices);
    }
    cutter.report(warnings);
    return primitive;
}

} // namespace

Model read_stl(const std::filesystem::path& file) {
    MeshBytes bytes = read_mesh_bytes(file);
    const Facets facets =
        is_text(bytes.text()) ? TextReader(file, bytes.text()).run() : read_binary(file, bytes.text());
    bytes = {}; // not needed while welding
    WarningList warnings;
    Primitive primitive = weld(facets.positions, warnings);
    if (facets.opposed > 0) warnings.add_count("facet normals oppose the winding, which decides", facets.opposed);
    return make_model(file, std::move(primitive), std::move(warnings));
}

} // namespace hachure::assets
