#include <hachure/runtime/ecs/field_text.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/runtime/ecs/reflected.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

namespace hachure {
namespace {

using namespace test;
using testing::StrEq;
using testing::ThrowsMessage;

class FieldTextTest : public testing::Test {
protected:
    TypeRegistry registry;
    const TypeInfo& type = registry.add<Everything>();

    const FieldInfo& field(const std::string& name) const { return *type.field(name); }
    FieldValue parse(const std::string& name, std::string_view text) const { return parse_field(field(name), text); }
    std::string format(const std::string& name, const FieldValue& value) const {
        return format_field(field(name), value);
    }
};

TEST_F(FieldTextTest, ReadsWhatUsersWrite) {
    EXPECT_EQ(parse("on", "false"), FieldValue(false));
    EXPECT_EQ(parse("on", " true\n"), FieldValue(true));
    EXPECT_EQ(parse("small", "-7"), FieldValue(std::int64_t{-7}));
    EXPECT_EQ(parse("seed", "18446744073709551615"), FieldValue(std::numeric_limits<std::uint64_t>::max()));
    EXPECT_EQ(parse("ratio", "0.05"), FieldValue(double{0.05f}));
    EXPECT_EQ(parse("ratio", "1e-2"), FieldValue(double{0.01f}));
    EXPECT_EQ(parse("exact", "0.3"), FieldValue(0.3));
    EXPECT_EQ(parse("offset", "1,2"), FieldValue(glm::vec2(1, 2)));
    for (const char* text : {"1,0,-1", "1 0 -1", "1, 0, -1", " 1 ,0 , -1 ", "1\t0  -1", "1.0,0.0,-1e0"})
        EXPECT_EQ(parse("direction", text), FieldValue(glm::vec3(1, 0, -1))) << text;
    EXPECT_EQ(parse("rotation", "0 0.6 0 0.8"), FieldValue(glm::quat(0.8f, 0, 0.6f, 0))) << "x y z w";
    EXPECT_EQ(parse("title", "  a, b #1 "), FieldValue(std::string("  a, b #1 "))) << "text is kept as it is";
    EXPECT_EQ(parse("title", ""), FieldValue(std::string()));
    EXPECT_EQ(parse("lens", " fisheye "), FieldValue(std::string("fisheye")));
    EXPECT_EQ(parse("target", " null "), FieldValue(Entity::null));
    EXPECT_EQ(parse("target", "12v3"), FieldValue(Entity{12, 3}));
}

TEST_F(FieldTextTest, ReadsHexColorsAsLinearLight) {
    const auto paint = std::get<glm::vec3>(parse("paint", "#ff8800"));
    EXPECT_EQ(paint.r, 1.0f);
    EXPECT_NEAR(paint.g, 0.246201f, 1e-6) << "0x88 / 255 = 0.533333, ((0.533333 + 0.055) / 1.055)^2.4";
    EXPECT_EQ(paint.b, 0.0f);
    EXPECT_NEAR(std::get<glm::vec3>(parse("paint", "#0A0a0A")).r, 10 / 255.0 / 12.92, 1e-8) << "the linear part";
    EXPECT_EQ(parse("glaze", "#ffffff"), FieldValue(glm::vec4(1)));
    EXPECT_EQ(parse("glaze", "#00ff0080"), FieldValue(glm::vec4(0, 1, 0, 128 / 255.0f)));
    EXPECT_EQ(parse("paint", "1 0.5 0"), FieldValue(glm::vec3(1, 0.5f, 0)));
}

TEST_F(FieldTextTest, SaysWhatIsWrong) {
    const auto fails = [&](const char* name, std::string_view text, const char* message) {
        EXPECT_THAT([&] { parse(name, text); }, ThrowsMessage<Error>(StrEq(message)));
    };
    fails("on", "yes", "everything.on: \"yes\" is neither true nor false");
    fails("small", "11", "everything.small: 11 is outside [-10, 10]");
    fails("small", "1.5", "everything.small: \"1.5\" is no integer");
    fails("small", "", "everything.small: \"\" is no integer");
    fails("count", "-1", "everything.count: \"-1\" is no integer");
    fails("count", "4294967296", "everything.count: 4294967296 does not fit in 32 bits");
    fails("big", "9223372036854775808", "everything.big: \"9223372036854775808\" is too large or too small");
    fails("ratio", "1.5", "everything.ratio: 1.5 is outside [0, 0.1]");
    fails("ratio", "0.05x", "everything.ratio: \"0.05x\" is no number");
    fails("ratio", "nan", "everything.ratio: the number is not finite");
    fails("exact", "inf", "everything.exact: the number is not finite");
    fails("exact", "1e400", "everything.exact: \"1e400\" is too large or too small");
    fails("ratio", "1e39", "everything.ratio: \"1e39\" is too large or too small");
    fails("offset", "1", "everything.offset: \"1\" has 1 numbers instead of 2");
    fails("offset", "1 2 3", "everything.offset: \"1 2 3\" has 3 numbers instead of 2");
    fails("offset", "1,,2", "everything.offset: \"\" is no number");
    fails("offset", "#ff8800", "everything.offset: \"#ff8800\" is no number");
    fails("direction", "0 0 2", "everything.direction: 2 is outside [-1, 1]");
    fails("rotation", "0 0 0 2", "everything.rotation: a rotation is a quaternion of length 1");
    fails("paint", "#ff880", "everything.paint: \"#ff880\" is not #rrggbb");
    fails("paint", "#ff88001", "everything.paint: \"#ff88001\" is not #rrggbb");
    fails("paint", "#ff880080", "everything.paint: \"#ff880080\" is not #rrggbb");
    fails("glaze", "#gg0000", "everything.glaze: \"#gg0000\" is neither #rrggbb nor #rrggbbaa");
    fails("paint", "#-12345", "everything.paint: \"#-12345\" is not #rrggbb");
    fails("target", "12", "everything.target: \"12\" is neither null nor a handle such as 12v3");
    fails("target", "12v", "everything.target: \"\" is no integer");
    fails("target", "12v0", "everything.target: 12v0 is no handle of a world");
    fails("target", "4294967295v1", "everything.target: null is no handle of a world");
    fails("target", "12v4294967296", "everything.target: \"4294967296\" is too large or too small");
    fails("lens", "Fisheye", "everything.lens: \"Fisheye\" is none of perspective, orthographic, fisheye");
}

TEST_F(FieldTextTest, LongTextIsCutInMessages) {
    try {
        parse("small", std::string(1'000'000, '7') + "x");
        FAIL();
    } catch (const Error& error) {
        EXPECT_LT(std::strlen(error.what()), 120u);
    }
}

TEST_F(FieldTextTest, WritesTheFewestSignificantDigits) {
    EXPECT_EQ(format("on", true), "true");
    EXPECT_EQ(format("small", std::int64_t{-3}), "-3");
    EXPECT_EQ(format("ratio", double{0.1f}), "0.1");
    EXPECT_EQ(format("exact", 0.1), "0.1");
    EXPECT_EQ(format("exact", 1.0 / 3), "0.3333333333333333");
    EXPECT_EQ(format("plane", glm::vec4(0, 1, -0.5f, 1e20f)), "0 1 -0.5 1e+20");
    EXPECT_EQ(format("rotation", glm::quat(1, 0, 0, 0)), "0 0 0 1");
    EXPECT_EQ(format("lens", std::string("fisheye")), "fisheye");
    EXPECT_EQ(format("target", Entity{12, 3}), "12v3");
}

TEST_F(FieldTextTest, DefaultsComeBack) {
    for (const FieldInfo& info : type.fields)
        EXPECT_EQ(parse_field(info, format_field(info, info.default_value)), info.default_value) << info.name;
}

TEST_F(FieldTextTest, NumbersComeBackExactly) {
    std::mt19937_64 random(1);
    // Any bit pattern: tiny, huge and subnormal ones; compared by bits, so that -0 counts.
    for (int i = 0; i < 20'000; ++i) {
        std::array<float, 4> v{};
        for (float& x : v) do
                x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            while (!std::isfinite(x));
        const glm::vec4 vector(v[0], v[1], v[2], v[3]);
        const auto back = std::get<glm::vec4>(parse("plane", format("plane", vector)));
        ASSERT_EQ(std::memcmp(&back, &vector, sizeof back), 0) << format("plane", vector);

        const double real = std::uniform_real_distribution<double>(0.1, 1)(random);
        ASSERT_EQ(parse("exact", format("exact", real)), FieldValue(real));
        const auto big = static_cast<std::int64_t>(random());
        ASSERT_EQ(parse("big", format("big", big)), FieldValue(big));
        const std::uint64_t seed = random();
        ASSERT_EQ(parse("seed", format("seed", seed)), FieldValue(seed));
    }
}

TEST_F(FieldTextTest, AnyTextGivesAValueInRangeOrAnError) {
    std::mt19937_64 random(2);
    constexpr std::string_view likely = "0123456789.,-+e #afxn\t ";
    int values = 0;
    for (int i = 0; i < 50'000; ++i) {
        std::string text(random() % 12, ' ');
        for (char& c : text) c = random() % 8 == 0 ? static_cast<char>(random()) : likely[random() % likely.size()];
        const FieldInfo& info = type.fields[random() % type.fields.size()];
        try {
            const FieldValue value = parse_field(info, text);
            ASSERT_EQ(info.fault(value), "") << info.name << " \"" << text << '"';
            Everything component;
            info.set(&component, value);
            ASSERT_EQ(info.get(&component), value) << info.name;
            ASSERT_EQ(parse_field(info, format_field(info, value)), value) << info.name;
            ++values;
        } catch (const Error& error) {
            ASSERT_TRUE(std::string_view(error.what()).starts_with("everything.")) << error.what();
        }
    }
    EXPECT_GT(values, 1000);
}

} // namespace
} // namespace hachure
