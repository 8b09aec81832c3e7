#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/geometry/shapes.h>

#include <gmock/gmock.h>
#include <zlib.h>

#include <chrono>
#include <cmath>

#include "mesh_file_fixture.h"

namespace hachure::assets {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class Obj : public MeshFileTest {
protected:
    Model read(std::string_view text) { return read_obj(write("model.obj", text)); }
    std::string fault(std::string_view text) { return MeshFileTest::fault(read_obj, write("model.obj", text)); }
};

constexpr std::string_view square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string with_square(std::string_view rest) { return std::string(square) + std::string(rest); }

TEST_F(Obj, ReadsATriangle) {
    const Model model = read("# a comment\nv 0 0 0\nv 1.5 0 -2e-1\nv +.25 1 0 # here too\nf 1 2 3\n");
    const Primitive& p = only(model);
    EXPECT_THAT(p.positions, ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1.5f, 0, -0.2f), glm::vec3(0.25f, 1, 0)));
    EXPECT_THAT(p.indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(p.normals, IsEmpty());
    EXPECT_THAT(p.texcoords[0], IsEmpty());
    EXPECT_EQ(p.material, -1);
    EXPECT_THAT(model.warnings, IsEmpty());
    EXPECT_EQ(model.meshes[0].name, "model");
    ASSERT_THAT(model.scenes, SizeIs(1));
    EXPECT_THAT(model.scenes[0].roots, ElementsAre(0));
    EXPECT_EQ(model.nodes.at(0).mesh, 0);
}

TEST_F(Obj, CutsPolygonsConvexAndConcave) {
    EXPECT_THAT(only(read(with_square("f 1 2 3 4\n"))).indices, ElementsAre(0, 1, 2, 0, 2, 3));
    // An arrowhead whose notch is not at the first corner: a fan would cover what lies outside.
    const Model model = read("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 0.5 1 0\nf 1 2 3 4\n");
    const Primitive& p = only(model);
    ASSERT_THAT(p.indices, SizeIs(6));
    for (std::size_t i = 0; i < 6; i += 3) {
        const glm::vec3 a = p.positions[p.indices[i]], b = p.positions[p.indices[i + 1]],
                        c = p.positions[p.indices[i + 2]];
        EXPECT_GT(glm::cross(b - a, c - a).z, 0.0f);
    }
}

TEST_F(Obj, ReadsEveryFormOfCorner) {
    const std::string lists = with_square("vt 0 0\nvt 1 0.25\nvn 0 0 2\nvn 0 0 1\n");
    EXPECT_THAT(only(read(lists + "f 1/1 2/2 3/1\n")).texcoords[0],
                ElementsAre(glm::vec2(0, 1), glm::vec2(1, 0.75f), glm::vec2(0, 1))); // from the top, as in glTF
    EXPECT_THAT(only(read(lists + "f 1//1 2//1 3//2\n")).normals,
                ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)));
    const Model full = read(lists + "f 1/1/1 2/2/1 3/1/2\n");
    EXPECT_THAT(only(full).normals, SizeIs(3));
    EXPECT_THAT(only(full).texcoords[0], SizeIs(3));
    EXPECT_THAT(only(read(lists + "f 1/ 2/ 3/\n")).texcoords[0], IsEmpty());
}

TEST_F(Obj, CountsNegativeIndicesFromTheEnd) {
    const Model model = read(with_square("f -4 -3 -2\nv 9 9 9\nf -1 -5 -4\n"));
    const Primitive& p = only(model);
    EXPECT_THAT(p.indices, ElementsAre(0, 1, 2, 3, 0, 1));
    EXPECT_EQ(p.positions[3], glm::vec3(9, 9, 9));
}

TEST_F(Obj, AFaceMayNameWhatFollows) {
    EXPECT_THAT(only(read("f 1 2 3\n" + std::string(square))).indices, ElementsAre(0, 1, 2));
}

TEST_F(Obj, KeepsHardEdgesAndJoinsEqualCorners) {
    // Two triangles of one plane share the edge 1-3; with different normals at one corner only.
    const Model model = read(with_square("vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//1 3//2 4//1\n"));
    EXPECT_THAT(only(model).positions, SizeIs(5));
    EXPECT_THAT(only(model).indices, ElementsAre(0, 1, 2, 0, 3, 4));
}

TEST_F(Obj, ObjectsAreMeshesAndMaterialsPrimitives) {
    const Model model =
        read(with_square("usemtl red\nf 1 2 3\no lid\nf 1 2 4\nusemtl blue\ng part\nf 2 3 4\nusemtl red\n"
                         "g other\nf 1 3 4\n"));
    ASSERT_THAT(model.meshes, SizeIs(2));
    EXPECT_EQ(model.meshes[0].name, "model");
    EXPECT_EQ(model.meshes[1].name, "lid");
    EXPECT_THAT(model.scenes[0].roots, ElementsAre(0, 1));
    EXPECT_EQ(model.nodes[1].name, "lid");
    ASSERT_THAT(model.materials, SizeIs(2));
    EXPECT_EQ(model.materials[0].name, "red");
    ASSERT_THAT(model.meshes[1].primitives, SizeIs(2));
    EXPECT_EQ(model.meshes[1].primitives[0].material, 0);
    EXPECT_THAT(model.meshes[1].primitives[0].indices, SizeIs(6)); // joined over the run of another material
    EXPECT_EQ(model.meshes[1].primitives[1].material, 1);
    EXPECT_THAT(model.warnings, ElementsAre("materials not defined: red, blue"));
}

TEST_F(Obj, ReadsMaterialsBesideTheFile) {
    write("lib/all.mtl", "newmtl other\nKd 1 1 1\n\nnewmtl red\nKd 1 0.5 0\nKs 1 1 1\nd 0.25\nNs 10\nillum 2\n"
                         "map_Kd -s 1 1 1 sub\\red image.png\nbump b.png\n");
    write("sub/red image.png", "PNG");
    const Model model = read(with_square("mtllib lib/all.mtl\nusemtl red\nf 1 2 3\n"));
    ASSERT_THAT(model.materials, SizeIs(1));
    const Material& red = model.materials[0];
    EXPECT_NEAR(red.base_color.g, std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-6); // sRGB
    EXPECT_EQ(red.base_color.a, 0.25f);
    EXPECT_EQ(red.alpha_mode, AlphaMode::blend);
    EXPECT_EQ(red.metallic, 0.0f);
    ASSERT_EQ(red.base_color_texture.texture, 0);
    EXPECT_EQ(model.textures.at(0).image, 0);
    EXPECT_THAT(model.images.at(0).bytes, SizeIs(3));
    EXPECT_THAT(model.warnings, ElementsAre("options of map_Kd not read: -s", "material statements not read: bump"));
}

TEST_F(Obj, ReadsNothingOutsideOfItsFolder) {
    const std::filesystem::path outside = write("secret.mtl", "newmtl m\nKd 0 0 0\nmap_Kd secret.png\n");
    write("secret.png", "PNG");
    write("inside/own.mtl", "newmtl m\nmap_Kd ../secret.png\n");
    const std::string names[] = {outside.string(), "../secret.mtl",          "x/../../secret.mtl",
                                 "..\\secret.mtl", "http://host/secret.mtl", "C:\\secret.mtl"};
    for (const std::string& name : names) {
        const Model model = read_obj(write("inside/m.obj", with_square("mtllib " + name + "\nusemtl m\nf 1 2 3\n")));
        EXPECT_EQ(model.materials.at(0).base_color, glm::vec4(1.0f)) << name;
        ASSERT_THAT(model.warnings, SizeIs(2));
        EXPECT_THAT(model.warnings[0], HasSubstr("outside of the file's folder")) << name;
    }
    const Model model = read_obj(write("inside/m.obj", with_square("mtllib own.mtl\nusemtl m\nf 1 2 3\n")));
    EXPECT_THAT(model.images, IsEmpty());
    EXPECT_EQ(model.materials[0].base_color_texture.texture, -1);
    EXPECT_THAT(model.warnings, ElementsAre("images outside of the file's folder are not read: ../secret.png"));
}

TEST_F(Obj, AMissingLibraryIsAWarning) {
    const Model model = read(with_square("mtllib gone.mtl\nusemtl a\nf 1 2 3\n"));
    EXPECT_THAT(model.warnings,
                ElementsAre("material libraries not found, or too large: gone.mtl", "materials not defined: a"));
}

TEST_F(Obj, ReadsVertexColorsAsSrgb) {
    const Model model = read("v 0 0 0 1 0 0.5\nv 1 0 0 0 1 0\nv 0 1 0\nf 1 2 3\n");
    const Primitive& p = only(model);
    ASSERT_THAT(p.colors, SizeIs(3));
    EXPECT_NEAR(p.colors[0].b, 0.21404, 1e-5);
    EXPECT_EQ(p.colors[2], glm::vec4(1.0f)); // without a colour of its own
    EXPECT_THAT(only(read("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n")).colors, IsEmpty()); // a weight
}

TEST_F(Obj, UnderstandsContinuedLinesAndEveryLineEnd) {
    const Model model = read("\xef\xbb\xbfv 0 0 0\r\nv 1 \\\r\n 0 0\r\nv 0 1 0\r\nf 1 2 \\\n\\\n 3\r\n\r\n");
    EXPECT_THAT(only(model).indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(model.warnings, IsEmpty());
    EXPECT_THAT(only(read(with_square("f 1 2 3"))).indices, SizeIs(3)); // no end of the last line
    EXPECT_THAT(read(with_square("f 1 2 3\n") + std::string(1, '\0')).warnings, IsEmpty());
}

TEST_F(Obj, SaysOnceWhatItDoesNotRead) {
    const Model model = read(with_square("l 1 2\np 1\nl 2 3\ns off\ng a\ncurv2 1 2\nf 1 2 3\n"));
    EXPECT_THAT(model.warnings, ElementsAre("statements not read: l, p, curv2"));
}

TEST_F(Obj, DropsFacesThatAreNone) {
    const Model model = read(with_square("f 1 2\nf 1\nf\nf 1 1 2 2\nf 1 1 2\nf 1 2 2 3\n"));
    EXPECT_THAT(only(model).indices, ElementsAre(0, 0, 1, 0, 1, 2)); // a triangle stays as it is
    EXPECT_THAT(model.warnings,
                ElementsAre("4 faces with fewer than three corners are dropped", "1 triangles repeat a vertex"));
}

TEST_F(Obj, DropsNormalsWithoutADirection) {
    const std::string lists = with_square("vn 0 0 1\nvn 0 0 0\nvn nan 0 1\n");
    for (const std::string face : {"f 1//1 2//1 3//2\n", "f 1//3 2//1 3//1\n", "f 1//1 2//1 3\n"}) {
        const Model model = read(lists + face);
        EXPECT_THAT(only(model).normals, IsEmpty()) << face;
        EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("unusable normals"))) << face;
    }
}

TEST_F(Obj, ReadsNumbersAtTheEdgeOfFloat) {
    const Model model = read("v 1e-60 3.4028234e38 -0\nv 1e-400 0.1 1\nv 0 1 16777217\nf 1 2 3\n");
    EXPECT_EQ(only(model).positions[0], glm::vec3(0.0f, 3.4028234e38f, 0.0f));
    EXPECT_EQ(only(model).positions[1].x, 0.0f);
    EXPECT_EQ(only(model).positions[1].y, 0.1f);
}

TEST_F(Obj, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(fault(""), "the file is empty");
    EXPECT_EQ(fault("v 0 0 0\n"), "no triangles");
    EXPECT_EQ(fault("\n\n#\n"), "no triangles");
    EXPECT_EQ(fault(with_square("f 1 2\n")), "no triangles");
    EXPECT_EQ(fault(with_square("f 1 2 5\n")), "index out of range (line 5)");
    EXPECT_EQ(fault(with_square("\nf 1 2 0\n")), "index out of range (line 6)");
    EXPECT_EQ(fault(with_square("f 1 2 -5\n")), "index out of range (line 5)");
    EXPECT_EQ(fault(with_square("f 1 2 99999999999\n")), "index out of range (line 5)");
    EXPECT_EQ(fault(with_square("f 1 2 99999999999999999999\n")), "expected an index (line 5)");
    EXPECT_EQ(fault(with_square("f 1/1 2 3\n")), "index out of range (line 5)");
    EXPECT_EQ(fault(with_square("f 1//1 2 3\n")), "index out of range (line 5)");
    EXPECT_EQ(fault(with_square("f 1/2/3/4 2 3\n")), "expected v, v/t, v//n or v/t/n (line 5)");
    EXPECT_EQ(fault(with_square("f a 2 3\n")), "expected an index (line 5)");
    EXPECT_EQ(fault("v 0 0\n"), "a position has three numbers (line 1)");
    EXPECT_EQ(fault("v 0 0 nan\n"), "a position is not finite (line 1)");
    EXPECT_EQ(fault("v 0 0 1e60\n"), "a position is not finite (line 1)");
    EXPECT_EQ(fault("v 0 0 -inf\n"), "a position is not finite (line 1)");
    EXPECT_EQ(fault("v 0 0 1x\n"), "expected a number (line 1)");
    EXPECT_EQ(fault("vn 1 0\n"), "a normal has three numbers (line 1)");
}

TEST_F(Obj, RefusesWhatIsNoFile) {
    EXPECT_EQ(MeshFileTest::fault(read_obj, folder()), "is a directory");
    EXPECT_EQ(MeshFileTest::fault(read_obj, folder() / "none.obj"), "no such file");
    EXPECT_EQ(MeshFileTest::fault(read_obj, "/dev/null"), "is not a regular file");
}

TEST_F(Obj, RefusesAFileThatIsLocked) {
    const std::filesystem::path locked = write("locked.obj", with_square("f 1 2 3\n"));
    std::filesystem::permissions(locked, std::filesystem::perms::none);
    if (geteuid() == 0) GTEST_SKIP() << "nothing is locked for the superuser";
    EXPECT_EQ(MeshFileTest::fault(read_obj, locked), "Permission denied");
}

TEST_F(Obj, EveryTruncationIsReadOrRefused) {
    const std::string text = with_square("vt 0.5 0.5\nvn 0 0 1\nusemtl m\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\n");
    for (std::size_t size = 0; size < text.size(); ++size) {
        const std::filesystem::path file = write("cut.obj", std::string_view(text).substr(0, size));
        try {
            EXPECT_FALSE(only(read_obj(file)).indices.empty()) << size;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), StartsWith(file.string()));
        }
    }
}

TEST_F(Obj, ManyPartsAreFoldedTogether) {
    std::string text(square);
    for (int i = 0; i < 70000; ++i) text += "o a\nf 1 2 3\n";
    const Model model = read(text);
    EXPECT_EQ(model.meshes.size(), 65535u); // and the one that starts the file, which is empty
    EXPECT_THAT(model.warnings, ElementsAre("4465 objects are more than can be kept apart"));
}

TEST_F(Obj, GivesTheMeshThatWasWritten) {
    const geometry::Shape shape = geometry::irregular_torus(2.0, 0.5, 40, 20, 0.4, 1);
    std::string text;
    for (const glm::vec3& p : shape.positions)
        text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    for (std::size_t i = 0; i < shape.indices.size(); i += 3)
        text += "f " + std::to_string(shape.indices[i] + 1) + " " + std::to_string(shape.indices[i + 1] + 1) + " " +
                std::to_string(shape.indices[i + 2] + 1) + "\n";
    const Model model = read(text);
    const Primitive& p = only(model);
    ASSERT_EQ(p.positions.size(), shape.positions.size());
    ASSERT_EQ(p.indices.size(), shape.indices.size());
    for (std::size_t i = 0; i < p.indices.size(); ++i) // vertices are numbered by their first use
        ASSERT_LT(glm::distance(p.positions[p.indices[i]], shape.positions[shape.indices[i]]), 2e-6f);
}

class Gzip : public MeshFileTest {
protected:
    std::filesystem::path write_gzip(const std::string& name, std::string_view text) {
        const std::filesystem::path path = folder() / name;
        const gzFile file = gzopen(path.c_str(), "wb9");
        gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
        gzclose(file);
        return path;
    }
    static std::string content(const std::filesystem::path& path) {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

TEST_F(Gzip, ReadsTheMeshInside) {
    const Model model = read_mesh(write_gzip("Shape.OBJ.gz", with_square("f 1 2 3\n")));
    EXPECT_THAT(only(model).indices, ElementsAre(0, 1, 2));
    EXPECT_EQ(model.meshes[0].name, "Shape");
}

TEST_F(Gzip, ReadsMembersOneAfterTheOther) {
    const std::string first = content(write_gzip("a.gz", square)), second = content(write_gzip("b.gz", "f 1 2 3\n"));
    EXPECT_THAT(only(read_obj(write("c.obj.gz", first + second))).indices, SizeIs(3));
}

TEST_F(Gzip, RefusesWhatIsNotSound) {
    const std::string sound = content(write_gzip("a.obj.gz", with_square("f 1 2 3\n")));
    for (std::size_t size = 1; size < sound.size(); ++size)
        EXPECT_EQ(fault(read_obj, write("cut.obj.gz", sound.substr(0, size))), "truncated gzip data") << size;
    EXPECT_THAT(fault(read_obj, write("text.obj.gz", square)), StartsWith("not sound gzip data"));
    std::string damaged = sound;
    damaged[damaged.size() - 6] ^= 1; // the checksum
    EXPECT_THAT(fault(read_obj, write("sum.obj.gz", damaged)), StartsWith("not sound gzip data"));
    EXPECT_EQ(fault(read_obj, write_gzip("empty.obj.gz", "")), "the file is empty");
}

TEST_F(Gzip, BoundsWhatItInflates) {
    const std::filesystem::path bomb = write_gzip("bomb.obj.gz", std::string(40'000'000, ' '));
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THAT(fault(read_obj, bomb), StartsWith("inflates to more than 64 times"));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

} // namespace
} // namespace hachure::assets
