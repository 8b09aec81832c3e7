#include <hachure/runtime/assets/mesh_files.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "mesh_file_fixture.h"

namespace hachure::assets {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class Ply : public MeshFileTest {
protected:
    Model read(std::string_view text) { return read_ply(write("model.ply", text)); }
    std::string fault(std::string_view text) { return MeshFileTest::fault(read_ply, write("model.ply", text)); }
};

std::string header(std::string_view format, std::string_view rest) {
    return "ply\nformat " + std::string(format) + " 1.0\n" + std::string(rest) + "end_header\n";
}

constexpr std::string_view three_positions = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
constexpr std::string_view one_face = "element face 1\nproperty list uchar int vertex_indices\n";

std::string ascii(std::string_view body, std::string_view faces = one_face) {
    return header("ascii", std::string(three_positions) + std::string(faces)) + std::string(body);
}

TEST_F(Ply, ReadsAscii) {
    const Model model = read(ascii("0 0 0\n1 0 0\n0 1 0.5\n3 0 1 2\n"));
    EXPECT_THAT(only(model).positions, ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0.5f)));
    EXPECT_THAT(only(model).indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(only(model).normals, IsEmpty());
    EXPECT_THAT(model.warnings, IsEmpty());
    EXPECT_EQ(model.meshes[0].name, "model");
}

TEST_F(Ply, ReadsCommentsCarriageReturnsAndPolygons) {
    const Model model = read("ply\r\ncomment a\r\nformat ascii 1.0\r\ncomment b\r\nobj_info c\r\nelement vertex 5\r\n"
                             "property float32 x\r\nproperty float64 y\r\nproperty int z\r\nelement face 2\r\n"
                             "property list uint8 uint32 vertex_index\r\nend_header\r\n"
                             "0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n5 5 5\r\n4 0 1 2 3\r\n3 2 1 4\r\n");
    EXPECT_THAT(only(model).indices, ElementsAre(0, 1, 2, 0, 2, 3, 2, 1, 4));
}

TEST_F(Ply, ReadsAttributesInAnyOrderAndSkipsTheRest) {
    const Model model =
        read(header("ascii", "element camera 1\nproperty float fov\nproperty list int float k\n"
                             "element vertex 3\nproperty uchar red\nproperty float y\nproperty float x\n"
                             "property float nz\nproperty float ny\nproperty float nx\n"
                             "property float quality\nproperty float z\nproperty uchar green\n"
                             "property uchar blue\nproperty float t\nproperty float s\n"
                             "property list uchar float more\n"
                             "element face 1\nproperty uchar flags\nproperty list uchar int vertex_indices\n"
                             "property list uchar float texcoord\n") +
             "90 2 1 2\n"
             "255 2 1 3 0 0 7 5 0 51 0.25 0.75 0\n"
             "0 0 0 0 2 0 7 0 0 0 0 0 1 9\n"
             "0 0 9 0 0 1 7 0 0 0 0 0 2 9 9\n"
             "4 3 0 1 2 2 0.5 0.5\n");
    const Primitive& p = only(model);
    EXPECT_EQ(p.positions[0], glm::vec3(1, 2, 5));
    EXPECT_THAT(p.normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)));
    EXPECT_EQ(p.texcoords[0][0], glm::vec2(0.75f, 0.75f));
    EXPECT_EQ(p.colors[0].r, 1.0f);
    EXPECT_NEAR(p.colors[0].b, std::pow((0.2 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_EQ(p.colors[0].a, 1.0f);
    EXPECT_THAT(p.indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(model.warnings, ElementsAre("elements not read: camera", "vertex properties not read: quality, more",
                                            "face properties not read: flags, texcoord"));
}

/// One file with every type of number, and what it must give.
template <bool big> std::string binary_ply() {
    Bytes b(big);
    b.text(header(big ? "binary_big_endian" : "binary_little_endian",
                  "element vertex 4\nproperty double x\nproperty short y\nproperty char z\nproperty ushort red\n"
                  "property ushort green\nproperty ushort blue\nproperty float alpha\nproperty int skipped\n"
                  "element face 2\nproperty list int ushort vertex_indices\nproperty uint skipped\n"
                  "element extra 1\nproperty list ushort double numbers\n"));
    for (int i = 0; i < 4; ++i) {
        b.add(i == 1 || i == 2 ? 1.5 : 0.0).add(std::int16_t(i >= 2 ? -300 : 0)).add(std::int8_t(-i));
        b.add(std::uint16_t(65535)).add(std::uint16_t(0)).add(std::uint16_t(65535)).add(0.5f).add(std::int32_t(-1));
    }
    b.add(std::int32_t(4)).add(std::uint16_t(0)).add(std::uint16_t(1)).add(std::uint16_t(2)).add(std::uint16_t(3));
    b.add(std::uint32_t(7));
    b.add(std::int32_t(3)).add(std::uint16_t(3)).add(std::uint16_t(1)).add(std::uint16_t(0)).add(std::uint32_t(7));
    b.add(std::uint16_t(2)).add(1.0).add(2.0);
    return b.str();
}

TEST_F(Ply, ReadsBinaryOfEitherByteOrder) {
    for (const std::string& file : {binary_ply<false>(), binary_ply<true>()}) {
        const Model model = read(file);
        const Primitive& p = only(model);
        EXPECT_THAT(p.positions, ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1.5f, 0, -1), glm::vec3(1.5f, -300, -2),
                                             glm::vec3(0, -300, -3)));
        EXPECT_EQ(p.colors[2], glm::vec4(1, 0, 1, 0.5f));
        EXPECT_THAT(p.indices, SizeIs(9));
        EXPECT_THAT(std::vector(p.indices.end() - 3, p.indices.end()), ElementsAre(3, 1, 0));
    }
}

TEST_F(Ply, EveryTruncationOfABinaryFileIsRefused) {
    const std::string whole = binary_ply<false>();
    for (std::size_t size = 1; size < whole.size(); ++size) EXPECT_FALSE(fault(whole.substr(0, size)).empty()) << size;
}

TEST_F(Ply, ReadsStrips) {
    const std::string strips = "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                               "element tristrips 1\nproperty list int int vertex_indices\n";
    const Model model = read(header("ascii", strips) + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n"
                                                       "11 0 1 2 3 3 -1 2 3 4 5 -1\n");
    EXPECT_THAT(only(model).indices, ElementsAre(0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5));
}

TEST_F(Ply, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(fault("solid\n"), "not a PLY file: it does not start with \"ply\" (line 1)");
    EXPECT_EQ(fault("ply\nformat ascii 1.0\nelement vertex 3\n"), "the header does not end (line 4)");
    EXPECT_EQ(fault("ply\nelement vertex 3\n"), "expected the format (line 2)");
    EXPECT_EQ(fault("ply\nformat ascii 2.0\nend_header\n"), "unknown PLY version (line 2)");
    EXPECT_EQ(fault("ply\nformat utf8 1.0\nend_header\n"), "unknown PLY format (line 2)");
    EXPECT_EQ(fault(header("ascii", "property float x\n")), "a property before the first element (line 3)");
    EXPECT_EQ(fault(header("ascii", "element vertex 3\nproperty half x\n")), "unknown type of a property (line 4)");
    EXPECT_EQ(fault(header("ascii", "element vertex -3\n")), "expected the name and the count of an element (line 3)");
    EXPECT_EQ(fault(header("ascii", "element vertex 3\nproperty list float int x\n")),
              "the count of a list must be an integer (line 4)");
    EXPECT_EQ(fault(header("ascii", "elephant\n")), "unknown statement in the header (line 3)");
    EXPECT_EQ(fault(header("ascii", "element vertex 1\nproperty float x\n") + "1\n"),
              "vertices without x, y and z (line 6)");
    EXPECT_EQ(fault(header("ascii", three_positions) + "0 0 0\n1 0 0\n0 1 0\n"), "no triangles");
    EXPECT_EQ(fault(ascii("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")), "index out of range (line 13)");
    EXPECT_EQ(fault(ascii("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n")), "index out of range (line 13)");
    EXPECT_EQ(fault(ascii("0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n")), "a position is not finite (line 11)");
    EXPECT_EQ(fault(ascii("0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n")), "expected a number (line 11)");
    EXPECT_EQ(fault(ascii("0 0 0\n1 0 0\n0 1 0\n3 0 1")), "truncated (line 13)");
    EXPECT_EQ(fault(ascii("0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n")), "a list with a negative count (line 13)");
    EXPECT_EQ(fault(ascii("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "element face 1\nproperty list uchar int corners\n")),
              "faces without a list of vertices (line 12)");
}

TEST_F(Ply, ACountBeyondTheFileIsRefusedBeforeMemoryIsTaken) {
    for (const std::string format : {"ascii", "binary_little_endian"}) {
        const std::string claim = "element vertex 100000000\nproperty float x\nproperty float y\nproperty float z\n";
        EXPECT_THAT(fault(header(format, claim) + std::string(1000, '0')),
                    testing::StartsWith("truncated: the header claims"));
        EXPECT_THAT(fault(header(format, "element vertex 9223372036854775807\nproperty float x\n")),
                    testing::StartsWith("truncated: the header claims"));
    }
    EXPECT_THAT(fault(ascii("0 0 0\n1 0 0\n0 1 0\n100000000 0 1 2\n")),
                testing::StartsWith("truncated: a list claims"));
    Bytes list;
    list.text(header("binary_little_endian",
                     std::string(three_positions) + "element face 1\nproperty list uint int vertex_indices\n"));
    for (int i = 0; i < 9; ++i) list.add(float(i));
    list.add(std::uint32_t(0xffffffffu)).add(0).add(1).add(2);
    EXPECT_THAT(fault(list.str()), testing::StartsWith("truncated: a list claims"));
}

TEST_F(Ply, NonFiniteBinaryPositionsAreRefused) {
    Bytes b;
    b.text(header("binary_little_endian", std::string(three_positions) + std::string(one_face)));
    for (int i = 0; i < 9; ++i) b.add(i == 4 ? std::numeric_limits<float>::quiet_NaN() : float(i));
    b.add(std::uint8_t(3)).add(0).add(1).add(2);
    EXPECT_THAT(fault(b.str()), testing::StartsWith("a position is not finite (byte "));
}

} // namespace
} // namespace hachure::assets
