// Which channels are colour, normals and depth: by their names alone.

#include <hachure/runtime/assets/image_layers.h>

#include <gtest/gtest.h>

#include <sstream>

namespace hachure::assets {
namespace {

std::string names(const std::vector<ImageChannel>& channels) {
    std::string text;
    for (const ImageChannel& channel : channels) text += (text.empty() ? "" : " ") + channel.name;
    return text;
}

/// "colour | normal | depth" of a file with these channels in one part.
std::string found(const std::string& text) {
    std::istringstream stream(text);
    std::vector<ImageChannel> channels;
    for (std::string name; stream >> name;) channels.push_back({0, static_cast<int>(channels.size()), name});
    const ImageLayers layers = find_layers(channels);
    return names(layers.color) + " | " + names(layers.normal) + " | " + names(layers.depth);
}

TEST(ImageLayers, ColoursAreTakenByNameNotByOrder) {
    EXPECT_EQ(found("A B G R"), "R G B A |  | ");
    EXPECT_EQ(found("B G R Z"), "R G B |  | Z");
    EXPECT_EQ(found("A B G N.X N.Y N.Z R Z"), "R G B A | N.X N.Y N.Z | Z");
    EXPECT_EQ(found("AO.R AO.G AO.B B G R"), "R G B |  | ");
    EXPECT_EQ(found("A Y"), "Y A |  | ");
    EXPECT_EQ(found("red green blue alpha"), "red green blue alpha |  | ");
}

TEST(ImageLayers, LayersOfRenderers) {
    // Blender, one file of all passes: "V" is how its versions from 4 on call the channel of a depth.
    EXPECT_EQ(found("ViewLayer.Combined.A ViewLayer.Combined.B ViewLayer.Combined.G ViewLayer.Combined.R "
                    "ViewLayer.Depth.V ViewLayer.Mist.Z ViewLayer.Normal.X ViewLayer.Normal.Y ViewLayer.Normal.Z"),
              "ViewLayer.Combined.R ViewLayer.Combined.G ViewLayer.Combined.B ViewLayer.Combined.A | "
              "ViewLayer.Normal.X ViewLayer.Normal.Y ViewLayer.Normal.Z | ViewLayer.Depth.V");
    EXPECT_EQ(found("View.Layer.Depth.Z View.Layer.Normal.X View.Layer.Normal.Y View.Layer.Normal.Z"),
              " | View.Layer.Normal.X View.Layer.Normal.Y View.Layer.Normal.Z | View.Layer.Depth.Z");
    EXPECT_EQ(found("beauty.B beauty.G beauty.R depth.R normals.B normals.G normals.R"),
              "beauty.R beauty.G beauty.B | normals.R normals.G normals.B | depth.R");
    EXPECT_EQ(found("rgba.R rgba.G rgba.B rgba.A rgba.Z"), "rgba.R rgba.G rgba.B rgba.A |  | rgba.Z");
    EXPECT_EQ(found("R G B NORMAL.x NORMAL.y NORMAL.z Depth"), "R G B | NORMAL.x NORMAL.y NORMAL.z | Depth");
}

TEST(ImageLayers, OurOwnBuffers) {
    EXPECT_EQ(found("Z"), " |  | Z");
    EXPECT_EQ(found("normal.X normal.Y normal.Z"), " | normal.X normal.Y normal.Z | ");
    EXPECT_EQ(found("object_id"), "object_id |  | ");
    EXPECT_EQ(found("velocity.X velocity.Y"), "velocity.X velocity.Y |  | ");
}

TEST(ImageLayers, WhereNamesSayLittle) {
    EXPECT_EQ(found("diffuse.R diffuse.G diffuse.B"), "diffuse.R diffuse.G diffuse.B |  | ");
    EXPECT_EQ(found("N.R N.G N.B"), " | N.R N.G N.B | ") << "a normal is no colour";
    EXPECT_EQ(found("a1 a2 a3 a4 a5"), "a1 a2 a3 a4 |  | ");
    EXPECT_EQ(found("R G"), "R G |  | ");
    EXPECT_EQ(found("velocity.X velocity.Y velocity.Z"), "velocity.X velocity.Y velocity.Z |  | ");
    EXPECT_EQ(found("N.X N.Y"), "N.X N.Y |  | ") << "two of three are no normal";
    EXPECT_EQ(found(""), " |  | ");
    EXPECT_EQ(found(". .. R. .R"), ". .. R. .R |  | ");
}

TEST(ImageLayers, TheFirstOfSeveralCounts) {
    EXPECT_EQ(found("b.combined.R b.combined.G b.combined.B a.combined.R a.combined.G a.combined.B"),
              "b.combined.R b.combined.G b.combined.B |  | ");
    EXPECT_EQ(found("beauty.R beauty.G beauty.B Combined.R Combined.G Combined.B normal.X normal.Y normal.Z N.X N.Y "
                    "N.Z depth.Z Z"),
              "Combined.R Combined.G Combined.B | N.X N.Y N.Z | Z");
}

TEST(ImageLayers, ChannelsOfTwoPartsAreNoLayer) {
    const std::vector<ImageChannel> channels{{0, 0, "R"}, {0, 1, "G"}, {1, 0, "B"}, {1, 1, "N.X"}, {2, 0, "N.Y"}};
    const ImageLayers layers = find_layers(channels);
    EXPECT_EQ(names(layers.color), "R G") << "the first channels of the first part";
    EXPECT_TRUE(layers.normal.empty());
}

} // namespace
} // namespace hachure::assets
