#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/robustness/watched.h>
#include <hachure/tests/support/glb_file.h>
#include <hachure/tests/support/temp_folder.h>

#include <cstring>
#include <limits>

namespace hachure::test {
namespace {

/// `info` and `render` of a file that must be refused.
void expect_refused(const TempFolder& folder, const std::string& name) {
    const auto before = folder.listing();
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"info", name},
          std::vector<std::string>{"render", name, "-o", "out.png", "--size", "64x48"}}) {
        const ProcessResult result = forked_command(command, folder.path());
        EXPECT_TRUE(is_safe(result, name));
        EXPECT_EQ(result.exit_code, 1) << command[0] << " " << name;
    }
    EXPECT_EQ(folder.listing(), before);
}

void expect_refused(const std::string& name, const std::string& content) {
    const TempFolder folder;
    folder.write(name, content);
    expect_refused(folder, name);
}

TEST(MadeFiles, TheTriangleItselfIsDrawn) {
    const TempFolder folder;
    folder.write("t.glb", glb(triangle_json(), triangle_binary()));
    const ProcessResult result = forked_command({"render", "t.glb", "-o", "out.png", "--size", "64x48"}, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "out.png"));
}

TEST(MadeFiles, TruncatedGlb) {
    for (const std::string& whole : {glb(triangle_json(), triangle_binary()), two_squares_glb()})
        for (std::size_t part = 0; part < 16; ++part) {
            SCOPED_TRACE(part);
            expect_refused("cut.glb", whole.substr(0, whole.size() * part / 16));
        }
}

TEST(MadeFiles, TruncatedGltf) {
    const std::string whole = triangle_json();
    for (std::size_t part = 0; part < 16; ++part) expect_refused("cut.gltf", whole.substr(0, whole.size() * part / 16));
}

TEST(MadeFiles, TruncatedPng) {
    const TempFolder folder;
    assets::write_png(folder / "whole.png", assets::make_image(9, 7, 4, assets::PixelType::u8));
    const std::string whole = file_text(folder / "whole.png");
    for (std::size_t part = 0; part < 16; ++part) expect_refused("cut.png", whole.substr(0, whole.size() * part / 16));
}

TEST(MadeFiles, AccessorBeyondItsBuffer) {
    expect_refused("count.glb",
                   edited_triangle_glb(R"("componentType": 5126, "count": 3)", R"("componentType": 5126, "count": 4)"));
    expect_refused("offset.glb", edited_triangle_glb(R"("bufferView": 0,)", R"("bufferView": 0, "byteOffset": 4,)"));
    expect_refused("wrap.glb", edited_triangle_glb(R"("bufferView": 0,)",
                                                   R"("bufferView": 0, "byteOffset": 18446744073709551612,)"));
    expect_refused("view.glb", edited_triangle_glb(R"("byteOffset": 36)", R"("byteOffset": 40)"));
    expect_refused("buffer.glb", edited_triangle_glb(R"("byteLength": 44)", R"("byteLength": 4400)"));
    expect_refused("negative.glb", edited_triangle_glb(R"("count": 3)", R"("count": -3)"));
}

TEST(MadeFiles, HundredMillionElements) {
    const std::string glb_file = edited_triangle_glb(R"("count": 3)", R"("count": 100000000)");
    ASSERT_LT(glb_file.size(), 1024u);
    expect_refused("count.glb", glb_file);
    // Without a view the accessor is zeros, which no file pays for.
    expect_refused("zeros.glb", edited_triangle_glb(R"({"bufferView": 0, "componentType": 5126, "count": 3)",
                                                    R"({"componentType": 5126, "count": 100000000)"));
    expect_refused(
        "p.ply", "ply\nformat ascii 1.0\nelement vertex 100000000\nproperty float x\nproperty float y\nproperty float "
                 "z\nelement face 100000000\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n");
    expect_refused("o.off", "OFF\n100000000 100000000 0\n0 0 0\n");
    std::string stl(84, '\0');
    const std::uint32_t count = 100000000;
    std::memcpy(stl.data() + 80, &count, sizeof count);
    expect_refused("s.stl", stl);
}

TEST(MadeFiles, CyclicNodes) {
    const std::string nodes = R"("nodes": [{"mesh": 0}, {"name": "spare"}])";
    expect_refused("self.glb", edited_triangle_glb(nodes, R"("nodes": [{"mesh": 0, "children": [0]}])"));
    expect_refused("two.glb",
                   edited_triangle_glb(nodes, R"("nodes": [{"mesh": 0, "children": [1]}, {"children": [0]}])"));
    expect_refused("parents.glb",
                   edited_triangle_glb(nodes, R"("nodes": [{"mesh": 0, "children": [1, 1]}, {"name": "n"}])"));
}

TEST(MadeFiles, ChainOfNodesIsNoDanger) {
    // As deep as a file can make it: whatever walks the tree must not use the stack for it.
    std::string nodes = R"("nodes": [)";
    constexpr int depth = 20000;
    for (int i = 0; i < depth; ++i) nodes += "{\"children\": [" + std::to_string(i + 1) + "]},";
    const std::string json = nodes + R"({"mesh": 0}])";
    const TempFolder folder;
    folder.write("deep.glb", edited_triangle_glb(R"("nodes": [{"mesh": 0}, {"name": "spare"}])", json));
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"info", "deep.glb"},
          std::vector<std::string>{"render", "deep.glb", "-o", "out.png", "--size", "64x48"}})
        EXPECT_TRUE(is_safe(forked_command(command, folder.path()), "deep.glb"));
}

TEST(MadeFiles, NestedJsonIsNoDanger) {
    expect_refused("arrays.gltf", std::string(1 << 20, '['));
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
    expect_refused("objects.gltf", objects);
}

TEST(MadeFiles, PositionsThatAreNoNumbers) {
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        std::string binary = triangle_binary();
        std::memcpy(binary.data() + 16, &value, sizeof value);
        expect_refused("nan.glb", glb(triangle_json(), binary));
    }
    for (const char* value : {"nan", "inf", "-inf", "1e999"}) {
        expect_refused("nan.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 ") + value + "\nf 1 2 3\n");
        expect_refused("nan.off", std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 ") + value + "\n3 0 1 2\n");
    }
}

TEST(MadeFiles, IndicesOutOfRange) {
    std::string binary = triangle_binary();
    binary[36] = 7;
    expect_refused("index.glb", glb(triangle_json(), binary));
    expect_refused("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    expect_refused("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
}

TEST(MadeFiles, PathsOutOfTheFolder) {
    for (const char* uri : {"/etc/passwd", "../secret.bin", "a/../../secret.bin", "file:///etc/passwd",
                            "http://localhost/x.bin", "%2e%2e/secret.bin"}) {
        const TempFolder folder;
        std::filesystem::create_directory(folder / "in");
        folder.write("secret.bin", triangle_binary());
        std::string json = triangle_json();
        const std::string buffer = R"({"byteLength": 44})";
        json.replace(json.find(buffer), buffer.size(), std::string(R"({"byteLength": 44, "uri": ")") + uri + "\"}");
        folder.write("in/m.gltf", json);
        SCOPED_TRACE(uri);
        expect_refused(folder, "in/m.gltf");
    }
}

TEST(MadeFiles, HugeAndTinyCoordinatesAreDrawnOrRefused) {
    const TempFolder folder;
    for (const char* scale : {"1e38", "3e38", "1e30", "1e-30", "1e-45", "0"}) {
        folder.write("scale.obj", std::string("v 0 0 0\nv ") + scale + " 0 0\nv 0 " + scale + " 0\nf 1 2 3\n");
        SCOPED_TRACE(scale);
        EXPECT_TRUE(is_safe(forked_command({"info", "scale.obj"}, folder.path()), "scale.obj"));
        EXPECT_TRUE(is_safe(forked_command({"render", "scale.obj", "-o", "out.png", "--size", "64x48"}, folder.path()),
                            "scale.obj"));
    }
}

/// The bytes of a small file changed one at a time: what a flipped bit can do.
TEST(MadeFiles, FlippedBytes) {
    const std::string whole = glb(triangle_json(), triangle_binary());
    const TempFolder folder;
    for (std::size_t i = 0; i < whole.size(); i += 13) {
        std::string flipped = whole;
        flipped[i] = static_cast<char>(flipped[i] ^ (1 << (i % 8)));
        folder.write("f.glb", flipped);
        EXPECT_TRUE(is_safe(forked_command({"info", "f.glb"}, folder.path()), "f.glb")) << "byte " << i;
    }
}

TEST(MadeFiles, BrokenPicturesAndVideos) {
    for (const char* name :
         {"p.png", "p.jpg", "p.exr", "p.hdr", "p.tga", "p.bmp", "p.tif", "p.gif", "p.webp", "p.mp4", "p.avi"}) {
        const TempFolder folder;
        folder.write(
            name,
            "this is neither a picture nor a video, only some text that is long enough for every header there is");
        const ProcessResult result = forked_command({"info", name}, folder.path());
        EXPECT_TRUE(is_safe(result, name));
        EXPECT_EQ(result.exit_code, 1) << name << ": " << result.out;
    }
}

} // namespace
} // namespace hachure::test
