#include <hachure/runtime/assets/mesh_builder.h>
#include <hachure/runtime/assets/mesh_bytes.h>
#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/assets/ply_source.h>
#include <hachure/runtime/assets/text_scanner.h>

#include <array>

namespace hachure::assets {
namespace {

struct OffHeader {
    bool texcoords = false, colors = false, normals = false, binary = false;
};

/// The keyword [ST][C][N][4][n]OFF, then BINARY or nothing. Files in more than three dimensions are refused.
OffHeader parse_keyword(TextScanner& scan) {
    scan.skip_space_and_comments();
    std::string_view word = scan.word();
    OffHeader header;
    const auto take = [&](std::string_view prefix) {
        const bool has = word.starts_with(prefix);
        if (has) word.remove_prefix(prefix.size());
        return has;
    };
    header.texcoords = take("ST");
    header.colors = take("C");
    header.normals = take("N");
    if (word == "4OFF" || word == "nOFF" || word == "4nOFF") scan.fail("OFF with more than three dimensions");
    if (word != "OFF") scan.fail("not an OFF file: it does not start with \"OFF\"");
    scan.skip_blanks();
    if (scan.peek() == 'B') {
        if (scan.word() != "BINARY") scan.fail("expected the counts, or BINARY");
        header.binary = true;
        scan.skip_line();
    }
    return header;
}

/// Colours are given as bytes or as fractions; a file with any value above 1 means bytes.
void scale_byte_colors(std::vector<glm::vec4>& colors) {
    bool bytes = false;
    for (const glm::vec4& c : colors) bytes = bytes || c.x > 1.0f || c.y > 1.0f || c.z > 1.0f;
    if (!bytes) return;
    for (glm::vec4& c : colors) c = {c.x / 255.0f, c.y / 255.0f, c.z / 255.0f, c.w > 1.0f ? c.w / 255.0f : c.w};
}

/// Checks counts against the bytes that are left, each vertex and face taking at least so many.
void check_counts(std::int64_t vertices, std::int64_t faces, std::size_t left, std::size_t vertex_bytes,
                  std::size_t face_bytes, const auto& source) {
    if (vertices < 0 || faces < 0) source.fail("negative counts");
    const auto v = static_cast<std::uint64_t>(vertices), f = static_cast<std::uint64_t>(faces);
    if (v > left / vertex_bytes || f > (left - v * vertex_bytes) / face_bytes)
        source.fail("truncated: the counts are more than the file can hold");
}

class OffReader {
public:
    OffReader(OffHeader header, WarningList& warnings) : header_(header), warnings_(warnings) {}

    Primitive read_text(TextScanner& scan) {
        const std::int64_t vertices = integer(scan), faces = integer(scan);
        static_cast<void>(integer(scan)); // edges: many writers leave 0
        check_counts(vertices, faces, scan.remaining() + 1, 6, 2, scan);
        out_.positions.reserve(static_cast<std::size_t>(vertices));
        for (std::int64_t i = 0; i < vertices; ++i) text_vertex(scan);
        for (std::int64_t i = 0; i < faces; ++i) text_face(scan);
        return finish();
    }

    /// Geomview's binary form: 32-bit integers and floats, big endian.
    Primitive read_binary(PlyBinarySource<true> source, std::size_t left) {
        const std::int64_t vertices = source.read_integer(PlyType::i32), faces = source.read_integer(PlyType::i32);
        source.skip(PlyType::i32, 1);
        const std::size_t floats =
            3u + (header_.normals ? 3u : 0u) + (header_.colors ? 4u : 0u) + (header_.texcoords ? 2u : 0u);
        check_counts(vertices, faces, left, 4 * floats, 8, source);
        for (std::int64_t i = 0; i < vertices; ++i) {
            std::array<float, 12> row{};
            for (std::size_t k = 0; k < floats; ++k) row[k] = source.read_float(PlyType::f32);
            add_vertex(std::span(row).first(floats), source);
        }
        for (std::int64_t i = 0; i < faces; ++i) {
            const std::int64_t corners = source.read_integer(PlyType::i32);
            if (corners < 0 || !source.holds(PlyType::i32, static_cast<std::uint64_t>(corners)))
                source.fail("truncated: a face claims more than the file can hold");
            polygon_.clear();
            for (std::int64_t k = 0; k < corners; ++k) add_corner(source.read_integer(PlyType::i32), source);
            cutter_.add(out_.positions, polygon_, out_.indices);
            source.skip(PlyType::f32, static_cast<std::size_t>(source.read_integer(PlyType::u32))); // its colour
        }
        return finish();
    }

private:
    static std::int64_t integer(TextScanner& scan) {
        scan.skip_space_and_comments();
        std::int64_t value = 0;
        if (!scan.read(value) || !scan.at_word_end())
            scan.fail(scan.at_end() ? "truncated" : "expected a whole number");
        return value;
    }

    void text_vertex(TextScanner& scan) {
        scan.skip_space_and_comments();
        std::array<float, 12> row{};
        std::size_t count = 0;
        for (scan.skip_blanks(); count < row.size() && !scan.at_line_end(); scan.skip_blanks(), ++count)
            if (!scan.read(row[count]) || !scan.at_word_end()) scan.fail("expected a number");
        const std::size_t least = 3u + (header_.normals ? 3u : 0u) + (header_.texcoords ? 2u : 0u);
        if (count < least) scan.fail(scan.at_end() ? "truncated" : "a vertex with too few numbers");
        add_vertex(std::span(row).first(count), scan);
        scan.skip_line();
    }

    /// Position, normal, colour, texture coordinate: what is left between its neighbours is the colour.
    void add_vertex(std::span<const float> row, const auto& source) {
        out_.positions.emplace_back(row[0], row[1], row[2]);
        if (!is_finite(out_.positions.back())) source.fail("a position is not finite");
        const std::size_t at = header_.normals ? 6 : 3;
        if (header_.normals) out_.normals.emplace_back(row[3], row[4], row[5]);
        const std::size_t end = header_.texcoords ? row.size() - 2 : row.size();
        if (header_.colors) {
            const bool has = end >= at + 3;
            out_.colors.push_back(has ? glm::vec4(row[at], row[at + 1], row[at + 2], end > at + 3 ? row[at + 3] : 1.0f)
                                      : glm::vec4(1.0f));
        }
        if (header_.texcoords) out_.texcoords[0].emplace_back(row[end], 1.0f - row[end + 1]); // counted from the bottom
    }

    void text_face(TextScanner& scan) {
        const std::int64_t corners = integer(scan);
        if (corners < 0 || static_cast<std::uint64_t>(corners) > scan.remaining() / 2 + 1)
            scan.fail("truncated: a face claims more than the file can hold");
        polygon_.clear();
        for (std::int64_t i = 0; i < corners; ++i) add_corner(integer(scan), scan);
        cutter_.add(out_.positions, polygon_, out_.indices);
        scan.skip_line(); // its colour
    }

    void add_corner(std::int64_t index, const auto& source) {
        if (index < 0 || static_cast<std::uint64_t>(index) >= out_.positions.size()) source.fail("index out of range");
        polygon_.push_back(static_cast<std::uint32_t>(index));
    }

    Primitive finish() {
        scale_byte_colors(out_.colors);
        cutter_.report(warnings_);
        return std::move(out_);
    }

    OffHeader header_;
    WarningList& warnings_;
    Primitive out_;
    FaceCutter cutter_;
    std::vector<std::uint32_t> polygon_; // scratch
};

} // namespace

Model read_off(const std::filesystem::path& file) {
    const MeshBytes bytes = read_mesh_bytes(file);
    TextScanner scan(file, bytes.text());
    WarningList warnings;
    const OffHeader header = parse_keyword(scan);
    OffReader reader(header, warnings);
    Primitive primitive =
        header.binary ? reader.read_binary(PlyBinarySource<true>(file, bytes.text(), scan.offset()), scan.remaining())
                      : reader.read_text(scan);
    return make_model(file, std::move(primitive), std::move(warnings));
}

} // namespace hachure::assets
