#include <hachure/runtime/assets/gltf_accessor.h>
#include <hachure/runtime/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;

/// The floats of an accessor of a document made by the builder.
std::vector<float> decode(const GltfBuilder& builder, int accessor) {
    const TempFolder folder;
    write_file(folder / "model.glb", builder.glb());
    GltfWarnings warnings;
    const GltfDocument document = open_gltf(folder / "model.glb", warnings);
    ByteBudget budget(document.file);
    GltfBuffers buffers(document, budget);
    return GltfAccessors(document, buffers, budget).floats(accessor);
}

std::string decode_error(const GltfBuilder& builder, int accessor) {
    try {
        (void)decode(builder, accessor);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// glTF 2.0, section 3.11: f = c / max for unsigned, max(c / max, -1) for signed.
double normalized(double value, double largest) { return std::max(value / largest, -1.0); }

template <class T> void expect_component_type(Component component) {
    const std::vector<T> values = {T(0), T(1), T(77), std::numeric_limits<T>::max(), std::numeric_limits<T>::min()};
    GltfBuilder builder;
    const int view = builder.view(bytes_of(values));
    const int plain = builder.accessor(view, component, "SCALAR", values.size());
    const int scaled = builder.accessor(view, component, "SCALAR", values.size());
    builder.root["accessors"][static_cast<std::size_t>(scaled)]["normalized"] = true;
    const auto plain_floats = decode(builder, plain), scaled_floats = decode(builder, scaled);
    ASSERT_EQ(plain_floats.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_FLOAT_EQ(plain_floats[i], static_cast<float>(values[i]));
        EXPECT_NEAR(scaled_floats[i], normalized(static_cast<double>(values[i]), std::numeric_limits<T>::max()), 1e-7);
    }
}

TEST(GltfAccessor, DecodesEveryComponentType) {
    expect_component_type<std::int8_t>(i8);
    expect_component_type<std::uint8_t>(u8);
    expect_component_type<std::int16_t>(i16);
    expect_component_type<std::uint16_t>(u16);
    expect_component_type<std::uint32_t>(u32);
    const std::vector<float> values = {0.0f, -1.5f, 1e-30f, 3e38f};
    GltfBuilder builder;
    const int accessor = builder.floats(values, 1);
    EXPECT_EQ(decode(builder, accessor), values);
}

TEST(GltfAccessor, StepsOverWhatIsInterleaved) {
    // Per vertex: 3 floats, 4 bytes, 2 shorts.
    Bytes data;
    for (int vertex = 0; vertex < 5; ++vertex) {
        const auto v = static_cast<float>(vertex);
        const auto s = static_cast<std::uint16_t>(vertex * 1000);
        for (const Bytes& part :
             {bytes_of(std::vector<float>{v, v + 0.25f, v + 0.5f}), Bytes{static_cast<unsigned char>(vertex), 1, 2, 3},
              bytes_of(std::vector<std::uint16_t>{s, 7})})
            data.insert(data.end(), part.begin(), part.end());
    }
    GltfBuilder builder;
    const int view = builder.view(data, 20);
    const int positions = builder.accessor(view, f32, "VEC3", 5);
    const int bytes = builder.accessor(view, u8, "VEC4", 5, 12);
    const int shorts = builder.accessor(view, u16, "VEC2", 5, 16);
    const auto p = decode(builder, positions), b = decode(builder, bytes), s = decode(builder, shorts);
    for (std::size_t i = 0; i < 5; ++i) {
        const auto v = static_cast<float>(i);
        EXPECT_EQ(std::vector<float>(p.begin() + 3 * i, p.begin() + 3 * i + 3),
                  (std::vector<float>{v, v + 0.25f, v + 0.5f}));
        EXPECT_EQ(std::vector<float>(b.begin() + 4 * i, b.begin() + 4 * i + 4), (std::vector<float>{v, 1, 2, 3}));
        EXPECT_EQ(std::vector<float>(s.begin() + 2 * i, s.begin() + 2 * i + 2), (std::vector<float>{v * 1000, 7}));
    }
}

TEST(GltfAccessor, SkipsThePaddingOfMatrixColumns) {
    GltfBuilder builder;
    // MAT2 of bytes: columns of 2 at multiples of 4. MAT3 of shorts: columns of 6 at multiples of 8.
    const int bytes = builder.view({1, 2, 99, 99, 3, 4, 99, 99, 5, 6, 99, 99, 7, 8});
    const int mat2 = builder.accessor(bytes, u8, "MAT2", 2);
    EXPECT_EQ(decode(builder, mat2), (std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8}));
    const int shorts = builder.view(bytes_of(std::vector<std::int16_t>{1, 2, 3, 99, 4, 5, 6, 99, 7, 8, -9}));
    const int mat3 = builder.accessor(shorts, i16, "MAT3", 1);
    EXPECT_EQ(decode(builder, mat3), (std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, -9}));
}

json sparse(int count, int index_view, Component index_type, int value_view) {
    return {{"count", count},
            {"indices", {{"bufferView", index_view}, {"componentType", static_cast<int>(index_type)}}},
            {"values", {{"bufferView", value_view}}}};
}

TEST(GltfAccessor, ReplacesSparseElements) {
    for (const Component type : {u8, u16, u32}) {
        GltfBuilder builder;
        const Bytes indices = type == u8    ? Bytes{1, 3}
                              : type == u16 ? bytes_of(std::vector<std::uint16_t>{1, 3})
                                            : bytes_of(std::vector<std::uint32_t>{1, 3});
        const int index_view = builder.view(indices);
        const int value_view = builder.view(bytes_of(std::vector<float>{10, 11, 30, 31}));
        const int based = builder.floats({0, 1, 2, 3, 4, 5, 6, 7}, 2);
        const int zeros = builder.accessor(-1, f32, "VEC2", 5);
        for (const int accessor : {based, zeros})
            builder.root["accessors"][static_cast<std::size_t>(accessor)]["sparse"] =
                sparse(2, index_view, type, value_view);
        EXPECT_EQ(decode(builder, based), (std::vector<float>{0, 1, 10, 11, 4, 5, 30, 31}));
        EXPECT_EQ(decode(builder, zeros), (std::vector<float>{0, 0, 10, 11, 0, 0, 30, 31, 0, 0}));
    }
}

TEST(GltfAccessor, RefusesSparseIndicesBeyondTheCount) {
    GltfBuilder builder;
    const int index_view = builder.view({1, 4});
    const int value_view = builder.view(bytes_of(std::vector<float>{1, 2}));
    const int accessor = builder.accessor(-1, f32, "SCALAR", 4);
    builder.root["accessors"][0]["sparse"] = sparse(2, index_view, u8, value_view);
    EXPECT_THAT(decode_error(builder, accessor), testing::HasSubstr("sparse index beyond its count (/accessors/0)"));
}

TEST(GltfAccessor, ZerosWithoutAView) {
    GltfBuilder builder;
    EXPECT_EQ(decode(builder, builder.accessor(-1, f32, "VEC3", 2)), std::vector<float>(6, 0.0f));
}

TEST(GltfAccessor, ReadsUpToTheLastByteAndNotBeyond) {
    GltfBuilder builder;
    const int view = builder.view(Bytes(20), 8);
    // Elements of 4 bytes at 0, 8 and 16: the last one ends with the view.
    EXPECT_EQ(decode(builder, builder.accessor(view, f32, "SCALAR", 3)).size(), 3u);
    const char* beyond = "ends beyond its buffer view";
    EXPECT_THAT(decode_error(builder, builder.accessor(view, f32, "SCALAR", 4)), testing::HasSubstr(beyond));
    EXPECT_THAT(decode_error(builder, builder.accessor(view, f32, "SCALAR", 3, 1)), testing::HasSubstr(beyond));
    EXPECT_THAT(decode_error(builder, builder.accessor(view, f32, "VEC2", 3)), testing::HasSubstr(beyond));
    EXPECT_THAT(decode_error(builder, builder.accessor(view, f32, "VEC3", 1)), testing::HasSubstr("view's stride"));
    EXPECT_THAT(decode_error(builder, builder.accessor(view, f32, "SCALAR", 1, 2'000'000'000)),
                testing::HasSubstr(beyond));
}

TEST(GltfAccessor, BoundsWhatAFileMayClaim) {
    GltfBuilder builder;
    const char* claim = "claims more data than a file of its size can hold";
    EXPECT_THAT(decode_error(builder, builder.accessor(-1, f32, "VEC3", 100'000'000)), testing::HasSubstr(claim));
    EXPECT_THAT(decode_error(builder, builder.accessor(-1, f32, "MAT4", 2'147'483'647)), testing::HasSubstr(claim));
}

} // namespace
} // namespace hachure::assets
