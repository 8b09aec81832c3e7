#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/geometry/mesh_health.h>
#include <hachure/runtime/geometry/shapes.h>

#include <gmock/gmock.h>

#include <limits>

#include "mesh_file_fixture.h"

namespace hachure::assets {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class Stl : public MeshFileTest {
protected:
    Model read(std::string_view text) { return read_stl(write("model.stl", text)); }
    std::string fault(std::string_view text) { return MeshFileTest::fault(read_stl, write("model.stl", text)); }
};

std::string binary_stl(const geometry::Shape& shape, std::string_view start, const glm::vec3& normal = {0, 0, 0}) {
    Bytes b;
    const std::string header = std::string(start) + std::string(80 - start.size(), ' ');
    b.text(header).add(static_cast<std::uint32_t>(shape.indices.size() / 3));
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        b.add(normal);
        for (std::size_t k = 0; k < 3; ++k) b.add(shape.positions[shape.indices[i + k]]);
        b.add(std::uint16_t(0));
    }
    return b.str();
}

constexpr std::string_view facet = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n"
                                   " endloop\nendfacet\n";

std::string text(std::string_view facets) {
    return "solid a name: facet or not\n" + std::string(facets) + "endsolid a name\n";
}

TEST_F(Stl, ReadsBinaryWhateverItsHeaderSays) {
    const geometry::Shape shape = geometry::icosphere(1.0, 2);
    for (const std::string_view start : {"", "solid model", "COLOR="}) {
        const Model model = read(binary_stl(shape, start));
        EXPECT_THAT(only(model).positions, SizeIs(162)) << start;
        EXPECT_TRUE(geometry::inspect(only(model).positions, only(model).indices).watertight()) << start;
        EXPECT_THAT(model.warnings, IsEmpty());
    }
}

TEST_F(Stl, ReadsTextAndWeldsIt) {
    const Model model =
        read(text(std::string(facet) + "FACET NORMAL 0 0 0\r\nOUTER LOOP\r\nVERTEX 1 0 -0\r\nVERTEX 1e0 1 0\r\n"
                                       "VERTEX 0 1 0\r\nENDLOOP\r\nENDFACET\r\n") +
             text(facet));
    EXPECT_THAT(only(model).positions, SizeIs(4));
    EXPECT_THAT(only(model).indices, ElementsAre(0, 1, 2, 1, 3, 2, 0, 1, 2));
    EXPECT_THAT(only(model).normals, IsEmpty());
    EXPECT_THAT(model.warnings, IsEmpty());
}

TEST_F(Stl, TheWindingDecidesAndTheNormalIsCompared) {
    const geometry::Shape shape = geometry::plane(1.0, 2); // faces +Y
    EXPECT_THAT(read(binary_stl(shape, "", {0, 1, 0})).warnings, IsEmpty());
    const Model model = read(binary_stl(shape, "", {0, -1, 0}));
    EXPECT_THAT(model.warnings, ElementsAre("8 facet normals oppose the winding, which decides"));
    EXPECT_THAT(only(model).normals, IsEmpty());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(read(binary_stl(shape, "", glm::vec3(nan))).warnings, IsEmpty());
}

TEST_F(Stl, KeepsTrianglesThatRepeatAVertex) {
    geometry::Shape shape = geometry::plane(1.0, 1);
    shape.indices.insert(shape.indices.end(), {0, 0, 1});
    const Model model = read(binary_stl(shape, ""));
    EXPECT_THAT(only(model).indices, SizeIs(9));
    EXPECT_THAT(model.warnings, ElementsAre("1 triangles repeat a vertex"));
}

TEST_F(Stl, SaysWhatIsWrongAndWhere) {
    EXPECT_THAT(fault("solid"), "no triangles");
    EXPECT_THAT(fault("nonsense"), StartsWith("truncated, or not an STL file"));
    EXPECT_EQ(fault(text("")), "no triangles");
    EXPECT_EQ(fault(text("vertex 0 0 0\n")), "expected a facet (line 2)");
    EXPECT_EQ(fault(text("facet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 0 1 endloop\n")),
              "expected \"vertex\" (line 2)");
    EXPECT_EQ(fault(text("facet normal 0 0 x\n")), "expected a number (line 2)");
    EXPECT_EQ(fault(text("facet normal 0 0 1\nouter loop\nvertex 0 0 inf\n")), "a position is not finite (line 4)");
    EXPECT_EQ(fault("solid\nfacet normal 0 0"), "truncated (line 2)");
    const std::string whole = binary_stl(geometry::plane(1.0, 1), "");
    EXPECT_THAT(fault(whole.substr(0, whole.size() - 1)), StartsWith("truncated: it claims 2 facets"));
    std::string huge = whole;
    huge.replace(80, 4, "\xff\xff\xff\xff");
    EXPECT_THAT(fault(huge), StartsWith("truncated: it claims 4294967295 facets"));
    geometry::Shape infinite = geometry::plane(1.0, 1);
    infinite.positions[0].x = std::numeric_limits<float>::infinity();
    EXPECT_EQ(fault(binary_stl(infinite, "")), "a position is not finite (byte 84)");
}

} // namespace
} // namespace hachure::assets
