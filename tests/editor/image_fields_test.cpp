// Pictures that fields name: scenes, styles and what is set on the command line find them, and faults have their place.

#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/editor/forked_command.h>
#include <hachure/tests/editor/program.h>

#include <gmock/gmock.h>

namespace hachure::test {
namespace {

using testing::HasSubstr;

class ImageFields : public ::testing::Test {
protected:
    ImageFields() {
        folder.write("a.obj", tetrahedron_obj);
        std::filesystem::create_directory(folder / "art");
        assets::Image ramp = assets::make_image(2, 1, 3, assets::PixelType::u8);
        for (int i = 0; i < 6; ++i) ramp.u8()[i] = i < 3 ? 40 : 200;
        assets::write_png(folder / "art/ramp.png", ramp);
        std::string broken = file_text(folder / "art/ramp.png");
        broken[broken.size() / 2] ^= 0x55;
        folder.write("art/broken.png", broken);
        folder.write("art/text.png", "no picture");
        assets::write_png(folder / "art/long.png", assets::make_image(5000, 1, 1, assets::PixelType::u8));
    }

    std::filesystem::path scene_with(const std::string& ramp) {
        return folder.write("s.scene.json", "{\"hachure_scene\": 1, \"style\": \"toon\",\n \"entities\": [{\"model\": "
                                            "\"a.obj\", \"toon\": {\"ramp\": \"" +
                                                ramp + "\"}}]}");
    }

    const TempFolder folder;
};

TEST_F(ImageFields, AreFoundFromTheFolderOfTheFileThatNamesThem) {
    scene_with("art/ramp.png");
    EXPECT_EQ(forked_command({"validate", "s.scene.json"}, folder.path()).out, "1 file, 0 faults, 0 warnings\n");
    folder.write("art/mine.json", R"({"hachure_style": 1, "surface": {"toon": {"ramp": "ramp.png"}}})");
    EXPECT_EQ(forked_command({"validate", "art/mine.json"}, folder.path()).out, "1 file, 0 faults, 0 warnings\n");
    EXPECT_TRUE(succeeded(hachure_program(
        folder, {"render", "a.obj", "-o", "style.png", "--size", "64x48", "--style", "art/mine.json"})));
    EXPECT_TRUE(succeeded(hachure_program(folder, {"render", "a.obj", "-o", "set.png", "--size", "64x48", "--style",
                                                   "toon", "--set", "toon.ramp=art/ramp.png"})));
    EXPECT_TRUE(succeeded(
        hachure_program(folder, {"render", "a.obj", "-o", "plain.png", "--size", "64x48", "--style", "toon"})));
    EXPECT_NE(file_text(folder / "set.png"), file_text(folder / "plain.png"));
}

TEST_F(ImageFields, FaultsNameFileAndPlace) {
    struct Case {
        const char* file;
        const char* fault;
    };
    for (const Case& one : {Case{"art/none.png", "art/none.png: is not a file that can be read"},
                            Case{"art/broken.png", "art/broken.png: "}, Case{"art/text.png", "art/text.png: "}}) {
        scene_with(one.file);
        const std::string place = "(line 2, column 51: /entities/0/toon/ramp)";
        const ProcessResult checked = forked_command({"validate", "s.scene.json"}, folder.path());
        EXPECT_EQ(checked.exit_code, 1);
        EXPECT_THAT(checked.out, testing::AllOf(HasSubstr(std::string("fault: s.scene.json: ") + one.fault),
                                                HasSubstr(place), HasSubstr("1 file, 1 fault, 0 warnings\n")));
        folder.write("mine.json", std::string("{\"hachure_style\": 1,\n \"surface\": {\"toon\": {\"ramp\": \"") +
                                      one.file + "\"}}}");
        EXPECT_THAT(forked_command({"validate", "mine.json"}, folder.path()).out,
                    testing::AllOf(HasSubstr(std::string("fault: mine.json: ") + one.fault),
                                   HasSubstr("(line 2, column 31: /surface/toon/ramp)"), HasSubstr("1 fault")));
        EXPECT_TRUE(failed(hachure_program(folder, {"render", "s.scene.json", "-o", "x.png"}), 1, one.fault));
        EXPECT_FALSE(std::filesystem::exists(folder / "x.png"));
    }
    for (const char* argument : {"toon.ramp=art/none.png", "toon.ramp=art/broken.png"})
        EXPECT_TRUE(failed(hachure_program(folder, {"render", "a.obj", "-o", "x.png", "--size", "64x48", "--style",
                                                    "toon", "--set", argument}),
                           1, std::string(argument).substr(10)));
    EXPECT_TRUE(failed(hachure_program(folder, {"render", "a.obj", "-o", "x.png", "--style", "mine.json"}), 1,
                       "art/text.png: "));
    EXPECT_FALSE(std::filesystem::exists(folder / "x.png"));
}

/// Pictures that can be read, and are no ramps.
TEST_F(ImageFields, ARampHasItsOwnLimits) {
    EXPECT_TRUE(failed(hachure_program(folder, {"render", "a.obj", "-o", "x.png", "--size", "64x48", "--style", "toon",
                                                "--set", "toon.ramp=art/long.png"}),
                       1, "art/long.png: is too large for a ramp: 5000x1, at most 4096x1024"));
}

} // namespace
} // namespace hachure::test
