#include <hachure/tests/systems/script/script_fixture.h>

namespace hachure::test {
namespace {

TEST_F(ScriptTest, VectorsCompute) {
    EXPECT_EQ(answer(R"(
        local function near(a, b) return (a - b):length() < 1e-6 end
        local v, w = vec3(1, 2, 3), vec3(4, 5, 6)
        assert(v + w == vec3(5, 7, 9) and w - v == vec3(3) and -v == vec3(-1, -2, -3))
        assert(v * 2 == vec3(2, 4, 6) and 2 * v == v * 2 and v * w == vec3(4, 10, 18) and w / 2 == vec3(2, 2.5, 3))
        assert(w / w == vec3(1) and 12 / vec2(3, 4) == vec2(4, 3))
        assert(v:dot(w) == 32 and v:cross(w) == vec3(-3, 6, -3) and vec2(3, 4):length() == 5)
        assert(near(vec3(0, 0, 9):normalize(), vec3(0, 0, 1)) and vec3():normalize() == vec3())
        assert(v:lerp(w, 0.5) == vec3(2.5, 3.5, 4.5) and vec4(1, 2, 3, 4).w == 4 and vec4(1, 2, 3, 4).a == 4)
        assert(v.x == 1 and v.y == 2 and v.z == 3 and v.r == 1 and v ~= w and v ~= vec2(1, 2))
        local q = quat.axis_angle(vec3(0, 0, 3), math.pi / 2)
        assert(near(q:rotate(vec3(1, 0, 0)), vec3(0, 1, 0)) and q * vec3(1, 0, 0) == q:rotate(vec3(1, 0, 0)))
        assert(near(q:inverse():rotate(vec3(0, 1, 0)), vec3(1, 0, 0)))
        local half = quat():slerp(q, 0.5)
        assert(near((half * half):rotate(vec3(1, 0, 0)), vec3(0, 1, 0)))
        assert(quat(0, 0, 0, 2) == quat() and quat(0, 0, 0, 2):length() == 1 and quat().w == 1)
        self.probe.text = tostring(v) .. tostring(vec2(0.5, -1)))"),
              "vec3(1, 2, 3)vec2(0.5, -1)");
}

TEST_F(ScriptTest, WrongArithmeticSaysWhatItIs) {
    const std::pair<const char*, const char*> wrong[] = {
        {"return vec3() + 1", "fox.lua:1: no way to add vec3(0, 0, 0) and 1"},
        {"return vec3() + vec2()", "fox.lua:1: no way to add vec3(0, 0, 0) and vec2(0, 0)"},
        {"return vec3() * 'a'", "fox.lua:1: no way to multiply vec3(0, 0, 0) and a"},
        {"return vec2().z", "fox.lua:1: vec2 has no element z"},
        {"return vec3(1, 2)", "fox.lua:1: vec3 takes 3 numbers"},
        {"return quat(0, 0, 0, 0)", "fox.lua:1: no rotation has length 0"},
        {"return quat.axis_angle(vec3(), 1)", "fox.lua:1: bad argument #1 to 'axis_angle' (the axis has no direction)"},
        {"self.transform.scale.x = 2",
         "fox.lua:1: a vector is a value: assign a new one, as in e.transform.scale = vec3(1, 2, 1)"},
    };
    for (const auto& [text, message] : wrong) {
        run(text);
        ASSERT_FALSE(errors().empty()) << text;
        EXPECT_EQ(errors().back().message, message);
        world().resource_mutable<ScriptErrors>().errors.clear();
    }
}

} // namespace
} // namespace hachure::test
