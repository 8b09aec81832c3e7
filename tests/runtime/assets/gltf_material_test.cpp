#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/assets/gltf_data_uri.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;
using testing::HasSubstr;

// Enough to be taken for one; nobody decodes it here.
const Bytes png = {0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a, 1, 2, 3};

std::string data_uri(const Bytes& bytes) { return "data:image/png;base64," + base64(bytes); }

bool same(const std::vector<std::byte>& a, const Bytes& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](std::byte x, unsigned char y) { return std::to_integer<unsigned char>(x) == y; });
}

TEST(GltfMaterial, ReadsEveryField) {
    GltfBuilder builder;
    builder.add("images", {{"uri", data_uri(png)}});
    builder.add("textures", {{"source", 0}});
    builder.add("materials",
                {{"name", "brass"},
                 {"pbrMetallicRoughness",
                  {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                   {"metallicFactor", 0.5},
                   {"roughnessFactor", 0.25},
                   {"baseColorTexture",
                    {{"index", 0},
                     {"texCoord", 0},
                     {"extensions",
                      {{"KHR_texture_transform",
                        {{"offset", {0.5, -1}}, {"scale", {2, 3}}, {"rotation", 1.5}, {"texCoord", 1}}}}}}},
                   {"metallicRoughnessTexture", {{"index", 0}, {"texCoord", 1}}}}},
                 {"normalTexture", {{"index", 0}, {"scale", 0.75}}},
                 {"emissiveFactor", {1, 2, 3}},
                 {"alphaMode", "MASK"},
                 {"alphaCutoff", 0.3},
                 {"doubleSided", true}});
    builder.add("materials", json::object());
    builder.root["extensionsUsed"] = {"KHR_texture_transform"};
    const Model model = builder.read();
    const Material& m = model.materials.at(0);
    EXPECT_EQ(m.name, "brass");
    EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.metallic, 0.5f);
    EXPECT_EQ(m.roughness, 0.25f);
    EXPECT_EQ(m.base_color_texture.offset, glm::vec2(0.5f, -1));
    EXPECT_EQ(m.base_color_texture.scale, glm::vec2(2, 3));
    EXPECT_EQ(m.base_color_texture.rotation, 1.5f);
    EXPECT_EQ(m.base_color_texture.texcoord, 1) << "the transform's set wins";
    EXPECT_EQ(m.metallic_roughness_texture.texture, 0);
    EXPECT_EQ(m.metallic_roughness_texture.texcoord, 1);
    EXPECT_EQ(m.normal_texture.texture, 0);
    EXPECT_EQ(m.normal_scale, 0.75f);
    EXPECT_EQ(m.emissive, glm::vec3(1, 2, 3));
    EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
    EXPECT_FLOAT_EQ(m.alpha_cutoff, 0.3f);
    EXPECT_TRUE(m.double_sided);
    EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
    const Material& plain = model.materials.at(1);
    EXPECT_EQ(plain.base_color, glm::vec4(1));
    EXPECT_EQ(plain.metallic, 1.0f);
    EXPECT_EQ(plain.base_color_texture.texture, -1);
    EXPECT_EQ(plain.alpha_mode, AlphaMode::opaque);
}

TEST(GltfTexture, ReadsSamplers) {
    GltfBuilder builder;
    builder.add("images", {{"uri", data_uri(png)}});
    builder.add("samplers", {{"magFilter", 9728}, {"minFilter", 9729}, {"wrapS", 33071}, {"wrapT", 33648}});
    builder.add("samplers", {{"minFilter", 9986}});
    builder.add("textures", {{"source", 0}, {"sampler", 0}});
    builder.add("textures", {{"source", 0}, {"sampler", 1}});
    builder.add("textures", {{"source", 0}});
    const Model model = builder.read();
    const Texture& first = model.textures.at(0);
    EXPECT_EQ(first.magnify, Filter::nearest);
    EXPECT_EQ(first.minify, Filter::linear);
    EXPECT_FALSE(first.mipmaps);
    EXPECT_EQ(first.wrap_s, Wrap::clamp);
    EXPECT_EQ(first.wrap_t, Wrap::mirror);
    EXPECT_EQ(model.textures.at(1).minify, Filter::nearest);
    EXPECT_TRUE(model.textures.at(1).mipmaps);
    EXPECT_EQ(model.textures.at(2).wrap_s, Wrap::repeat);
    EXPECT_TRUE(model.textures.at(2).mipmaps);
}

TEST(GltfImage, KeepsEncodedBytesFromEverywhere) {
    const TempFolder folder;
    GltfBuilder builder;
    builder.add("images", {{"bufferView", builder.view(png)}, {"mimeType", "image/png"}});
    builder.add("images", {{"uri", data_uri(png)}, {"name", "inline"}});
    builder.add("images", {{"uri", "sub%20folder/skin.png"}});
    std::filesystem::create_directory(folder / "sub folder");
    write_file(folder / "sub folder/skin.png", png);
    write_file(folder / "model.gltf", builder.gltf());
    const Model model = read_gltf(folder / "model.gltf");
    ASSERT_EQ(model.images.size(), 3u) << warnings_of(model);
    for (const EncodedImage& image : model.images) EXPECT_TRUE(same(image.bytes, png)) << image.name;
    EXPECT_EQ(model.images[0].name, "image 0");
    EXPECT_EQ(model.images[1].name, "inline");
    EXPECT_EQ(model.images[2].name, "sub folder/skin.png");
}

TEST(GltfImage, SkipsWhatItCannotHaveAndNamesIt) {
    const TempFolder folder;
    std::filesystem::create_directory(folder / "inner");
    write_file(folder / "secret.png", png);
    GltfBuilder builder;
    for (const char* uri : {"missing.png", "../secret.png", "http://host/a.png", "data:image/png;base64,!!!"})
        builder.add("images", {{"uri", uri}});
    builder.add("images", {{"uri", data_uri({'R', 'I', 'F', 'F', 0, 0, 0, 0, 'W', 'E', 'B', 'P'})}, {"name", "webp"}});
    builder.add("images", {{"uri", data_uri(png)}});
    for (int i = 0; i < 6; ++i) builder.add("textures", {{"source", i}});
    builder.add("textures", {{"extensions", {{"KHR_texture_basisu", {{"source", 5}}}}}});
    write_file(folder / "inner/model.gltf", builder.gltf());
    const Model model = read_gltf(folder / "inner/model.gltf");
    EXPECT_EQ(broken_promise(model), "");
    ASSERT_EQ(model.images.size(), 1u);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(model.textures[i].image, i == 5 ? 0 : -1);
    const std::string warnings = warnings_of(model);
    for (const char* part : {"missing.png: no such file", "leaves the file's folder", "a URL", "not base64", "webp",
                             "without a PNG or JPEG source"})
        EXPECT_THAT(warnings, HasSubstr(part));
}

TEST(GltfDataUri, DecodesBase64) {
    const auto text = [](std::string_view uri) {
        const auto bytes = decode_data_uri(uri);
        return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : "none";
    };
    // The test vectors of RFC 4648, section 10.
    EXPECT_EQ(text("data:;base64,"), "");
    EXPECT_EQ(text("data:;base64,Zg=="), "f");
    EXPECT_EQ(text("data:x/y;base64,Zm8="), "fo");
    EXPECT_EQ(text("data:;base64,Zm9v"), "foo");
    EXPECT_EQ(text("data:;base64,Zm9vYmE"), "fooba") << "without its padding";
    EXPECT_EQ(text("data:;base64,Zm9vYmFy"), "foobar");
    for (const char* bad :
         {"data:;base64,Z", "data:;base64,Zm9v!", "data:,text", "data:;base64", "Zm9v", "data:;base64,Zg=a"})
        EXPECT_EQ(text(bad), "none") << bad;
}

TEST(GltfExtensions, NamesWhatItDoesNotUnderstandOnce) {
    GltfBuilder builder;
    builder.root["extensionsUsed"] = {"EXT_new", "KHR_mesh_quantization", "EXT_new"};
    const Model model = builder.read();
    EXPECT_EQ(model.extensions.size(), 3u);
    EXPECT_EQ(warnings_of(model), "the extension EXT_new is not understood\n");
    builder.root["extensionsRequired"] = {"EXT_new"};
    EXPECT_THAT(error_of(builder), HasSubstr("requires the extension EXT_new"));
}

} // namespace
} // namespace hachure::assets
