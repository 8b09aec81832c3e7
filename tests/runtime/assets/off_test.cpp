#include <hachure/runtime/assets/mesh_files.h>

#include <gmock/gmock.h>

#include <cmath>

#include "mesh_file_fixture.h"

namespace hachure::assets {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class Off : public MeshFileTest {
protected:
    Model read(std::string_view text) { return read_off(write("model.off", text)); }
    std::string fault(std::string_view text) { return MeshFileTest::fault(read_off, write("model.off", text)); }
};

TEST_F(Off, ReadsFacesCommentsAndColours) {
    for (const std::string start :
         {"OFF\n4 2 0\n", "OFF 4 2 0\n", "# first\nOFF # here\n\n# there\n4 2 5 # counts\n"}) {
        const Model model =
            read(start + "0 0 0\n1 0 0 # a vertex\n\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n# last\n3 2 1 0 0.5\n");
        EXPECT_THAT(only(model).positions, SizeIs(4));
        EXPECT_THAT(only(model).indices, ElementsAre(0, 1, 2, 0, 2, 3, 2, 1, 0));
        EXPECT_THAT(only(model).colors, IsEmpty());
    }
}

TEST_F(Off, ReadsColoursAsBytesOrFractions) {
    const std::string faces = "3 0 1 2\n";
    const Model bytes = read("COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 0 0 0 255\n0 1 0 0 255 0 0\n" + faces);
    const double expected = std::pow((0.2 + 0.055) / 1.055, 2.4);
    EXPECT_EQ(only(bytes).colors[0].r, 1.0f);
    EXPECT_NEAR(only(bytes).colors[0].b, expected, 1e-6);
    const Model fractions = read("COFF\n3 1 0\n0 0 0 1 0 0.2 0.5\n1 0 0 0 0 0 1\n0 1 0 0 1 0 1\n" + faces);
    EXPECT_NEAR(only(fractions).colors[0].b, expected, 1e-6);
    EXPECT_EQ(only(fractions).colors[0].a, 0.5f);
    const Model three = read("COFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 0 0\n0 1 0 0 1 0\n" + faces);
    EXPECT_EQ(only(three).colors[0], glm::vec4(1, 0, 0, 1));
}

TEST_F(Off, ReadsNormalsAndTextureCoordinates) {
    const Model model = read("STCNOFF\n3 1 0\n0 0 0 0 0 2 1 0 0 1 0.5 0.25\n1 0 0 0 0 1 1 0 0 1 0 0\n"
                             "0 1 0 0 0 1 1 0 0 1 1 1\n3 0 1 2\n");
    EXPECT_EQ(only(model).normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(only(model).texcoords[0][0], glm::vec2(0.5f, 0.75f));
    EXPECT_EQ(only(model).colors[0], glm::vec4(1, 0, 0, 1));
}

std::string binary_off() {
    Bytes b(true);
    b.text("NOFF BINARY\n").add(4).add(2).add(0);
    for (int i = 0; i < 4; ++i)
        for (const float value : {i == 1 || i == 2 ? 1.0f : 0.0f, i >= 2 ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f, 1.0f})
            b.add(value);
    b.add(4).add(0).add(1).add(2).add(3).add(0);
    b.add(3).add(2).add(1).add(0).add(3).add(1.0f).add(0.0f).add(0.0f);
    return b.str();
}

TEST_F(Off, ReadsBinary) {
    const Model model = read(binary_off());
    EXPECT_THAT(only(model).positions, SizeIs(4));
    EXPECT_EQ(only(model).positions[2], glm::vec3(1, 1, 0));
    EXPECT_THAT(only(model).normals, SizeIs(4));
    EXPECT_THAT(only(model).indices, ElementsAre(0, 1, 2, 0, 2, 3, 2, 1, 0));
}

TEST_F(Off, EveryTruncationOfABinaryFileIsRefused) {
    const std::string whole = binary_off();
    for (std::size_t size = 1; size < whole.size(); ++size) EXPECT_FALSE(fault(whole.substr(0, size)).empty()) << size;
}

TEST_F(Off, SaysWhatIsWrongAndWhere) {
    EXPECT_THAT(fault("ply\n"), StartsWith("not an OFF file"));
    EXPECT_EQ(fault("4OFF\n1 1 0\n"), "OFF with more than three dimensions (line 1)");
    EXPECT_EQ(fault("OFF\n"), "truncated (line 2)");
    EXPECT_EQ(fault("OFF\n-1 1 0\n"), "negative counts (line 2)");
    EXPECT_EQ(fault("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "a vertex with too few numbers (line 4)");
    EXPECT_EQ(fault("OFF\n3 1 0\n0 0 0\n1 a 0\n0 1 0\n3 0 1 2\n"), "expected a number (line 4)");
    EXPECT_EQ(fault("OFF\n3 1 0\n0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n"), "a position is not finite (line 4)");
    EXPECT_EQ(fault("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "index out of range (line 6)");
    EXPECT_EQ(fault("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1"), "truncated (line 6)");
    EXPECT_EQ(fault("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "no triangles");
    EXPECT_THAT(fault("OFF\n100000000 1 0\n0 0 0\n"), StartsWith("truncated: the counts are more"));
    EXPECT_THAT(fault("OFF\n3 100000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                StartsWith("truncated: the counts are more"));
    EXPECT_THAT(fault("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n999999 0 1 2\n"), StartsWith("truncated: a face claims"));
}

} // namespace
} // namespace hachure::assets
