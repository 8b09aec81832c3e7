// What scripts must not be able to do: reach out, run for ever, take all memory, or depend on chance.

#include <hachure/tests/systems/script/script_fixture.h>

#include <chrono>

namespace hachure::test {
namespace {

constexpr const char* too_many_steps = "too many steps in one frame (does a loop not end?)";

struct SandboxTest : ScriptTest {
    /// Runs what must be stopped: for the steps or memory, soon, and without harm to the script beside it.
    std::string stopped(std::string_view text) {
        ScriptLimits limits;
        limits.steps = 1'000'000;
        limits.memory = std::size_t{8} << 20;
        limits.seconds = 0.5; // for what steps count badly
        world().set_resource(limits);
        const Entity other = add("function update() self.probe.count = self.probe.count + 1 end", "Other", "other.lua");
        const auto begin = std::chrono::steady_clock::now();
        const Entity bad = run(text);
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
        EXPECT_LT(passed.count(), 10.0) << text;
        app.run_frame(0);
        EXPECT_EQ(probe(other).count, 2) << text;
        EXPECT_NE(probe(bad).text, "free") << text;
        if (errors().size() != 1u) return "ended by itself: " + std::string(text);
        EXPECT_EQ(errors()[0].entity, bad);
        EXPECT_GT(errors()[0].line, 0) << text << "\n" << errors()[0].message;
        const std::string message = errors()[0].message;
        world().resource_mutable<ScriptErrors>().errors.clear();
        world().destroy(other);
        world().destroy(bad);
        return message;
    }
};

TEST_F(SandboxTest, NothingReachesOut) {
    for (const char* const name : {"io", "os", "package", "require", "debug", "load", "loadstring", "dofile",
                                   "loadfile", "string.dump", "math.randomseed", "_ENV.debug", "_G.io"})
        EXPECT_EQ(value(name), "nil") << name;
    EXPECT_EQ(value("getmetatable('')"), "false");
    EXPECT_EQ(value("getmetatable(self)"), "false");
    EXPECT_EQ(value("getmetatable(self.probe)"), "false");
    EXPECT_EQ(value("getmetatable(vec3())"), "false");
    EXPECT_EQ(value("getmetatable(_G)"), "false");
    EXPECT_EQ(value("getmetatable(math)"), "false");
}

TEST_F(SandboxTest, WhatScriptsShareCannotBeChanged) {
    const char* const wrong[] = {"math.pi = 3",
                                 "string.rep = nil",
                                 "vec3.zero = 1",
                                 "quat.axis_angle = nil",
                                 "scene.find = nil",
                                 "input.down = nil",
                                 "time.seconds = 0",
                                 "rawset(math, 'pi', 3)",
                                 "rawset(quat, 'axis_angle', 3)",
                                 "setmetatable(math, {})",
                                 "setmetatable(_G, nil)",
                                 "table.insert(table, 1)",
                                 "self.x = 1",
                                 "setmetatable({}, {__gc = print})",
                                 "setmetatable({}, {__mode = 'k'})",
                                 "string.format('%p', {})",
                                 "string.format('%-10p', {})",
                                 "collectgarbage('stop')",
                                 "collectgarbage('generational')"};
    for (const char* const text : wrong) {
        run(text);
        EXPECT_EQ(errors().size(), 1u) << text;
        world().resource_mutable<ScriptErrors>().errors.clear();
    }
    EXPECT_EQ(value("math.pi > 3.1 and ('a'):rep(2) == 'aa' and quat.axis_angle ~= nil"), "true");
}

TEST_F(SandboxTest, AGlobalOfOneScriptIsNoneOfAnother) {
    run("math_of_mine = 1; print = nil");
    EXPECT_EQ(value("math_of_mine == nil and print ~= nil"), "true");
}

TEST_F(SandboxTest, LoopsAreStopped) {
    EXPECT_EQ(stopped("while true do end"), std::string("fox.lua:1: ") + too_many_steps);
    EXPECT_EQ(stopped("\nrepeat until false"), std::string("fox.lua:2: ") + too_many_steps);
    EXPECT_EQ(stopped("::again:: goto again"), std::string("fox.lua:1: ") + too_many_steps);
    EXPECT_EQ(stopped("local function f() return f() end f()"), std::string("fox.lua:1: ") + too_many_steps);
    EXPECT_EQ(stopped("function update() while true do end end"), std::string("fox.lua:1: ") + too_many_steps);
}

TEST_F(SandboxTest, NothingCatchesAStop) {
    for (const char* const text : {
             "pcall(function() while true do end end) self.probe.text = 'free'",
             "while true do pcall(function() while true do end end) end",
             "pcall(pcall, pcall, function() while true do end end) self.probe.text = 'free'",
             "xpcall(function() while true do end end, function() while true do end end) self.probe.text = 'free'",
             "xpcall(error, function() while true do end end)",
             "xpcall(error, function() error('again') while true do end end) while true do end",
             "coroutine.resume(coroutine.create(function() while true do end end)) self.probe.text = 'free'",
             "pcall(coroutine.wrap(function() while true do end end)) self.probe.text = 'free'",
             "while true do coroutine.wrap(function() for i = 1, 150 do end end)() end",
             "while true do coroutine.resume(coroutine.create(function() for i = 1, 150 do end end)) end",
             "local co = coroutine.wrap(function() while true do coroutine.yield() end end) while true do co() end",
             "local m = {__close = function() while true do end end} local x <close> = setmetatable({}, m) "
             "while true do end",
             "local m = {__close = function() while true do end end} local function f(n) "
             "local x <close> = setmetatable({}, m) if n > 0 then f(n - 1) end while true do end end f(2000)",
             "local co = coroutine.create(function() local x <close> = setmetatable({}, {__close = function() while "
             "true do end end}) coroutine.yield() end) coroutine.resume(co) coroutine.close(co) "
             "self.probe.text = 'free'",
             "setmetatable(_ENV._G.x or {}, {__index = function() while true do end end}) while true do end",
             "local t = setmetatable({}, {__index = function(t, k) return t[k + 1] end}) pcall(function() return t[1] "
             "end) while true do end",
             "table.sort({3, 2, 1}, function(a, b) while true do end end)",
             "string.gsub('a', 'a', function() while true do end end)",
             "for w in string.gmatch(('a '):rep(1000), '%a') do while true do end end",
             "local t = setmetatable({}, {__tostring = function() while true do end end}) tostring(t)",
             "log(setmetatable({}, {__tostring = function() while true do end end}))",
             "for k in pairs(setmetatable({}, {__pairs = function() while true do end end})) do end",
         })
        EXPECT_TRUE(stopped(text).ends_with(too_many_steps)) << text;
}

TEST_F(SandboxTest, MemoryIsBounded) {
    for (const char* const text : {
             "local t = {} while true do t[#t + 1] = {} end",
             "local t = {} for i = 1, 1e9 do t[i] = i end",
             "local s = 'x' while true do s = s .. s end",
             "local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(100000) .. i end",
             "local t = {} while true do t[#t + 1] = coroutine.create(function() end) end",
             "local function f(...) return f(1, ...) end f()",
             "local t = {} while true do t[#t + 1] = vec3() end",
             "pcall(function() local t = {} while true do t[#t + 1] = ('x'):rep(1e5) .. #t end end) self.probe.text = "
             "'free'",
             "while true do pcall(function() local t = {} while true do t[#t + 1] = ('x'):rep(1e5) .. #t end end) end",
             "local s = ('x'):rep(1e6) while true do local t = s .. 'y' end",
             "local s = ('x'):rep(1e6) while true do local t = s:upper() end",
             "local t = {} for i = 1, 1e5 do t[i] = 'abcdefghijk' end while true do local s = table.concat(t) end",
             "string.format(('%s'):rep(100), ('x'):rep(1e6)) while true do end",
             "table.unpack({}, 1, 1e7)",
             "local s = ('%99d'):rep(1000) while true do pcall(string.format, s) end",
         }) {
        const std::string message = stopped(text);
        EXPECT_TRUE(message.ends_with(too_many_steps) || message.find("more than") != message.npos ||
                    message.find("stack overflow") != message.npos || message.ends_with("the script takes too long"))
            << text << "\n"
            << message;
    }
}

TEST_F(SandboxTest, WhatRunsInOnePieceIsCountedToo) {
    for (const char* const text : {
             "(('a'):rep(1e4)):find(('a*'):rep(20) .. 'b')",
             "(('a'):rep(1e5)):find('.-.-.-b')",
             "(('a'):rep(1e5)):match('(.*)(.*)(.*)b')",
             "(('x'):rep(1e6)):gsub('.-b', '')",
             "for w in (('('):rep(1e6)):gmatch('%b()') do end",
             "(('a'):rep(1e5)):find('[' .. ('b'):rep(1e5) .. ']')",
             "while true do (('a'):rep(1e6)):find(('a'):rep(5e5) .. 'b', 1, true) end",
             "while true do string.rep('', 1e18) end",
             "table.move({}, 1, 1e15, 2)",
             "table.move({}, 1, math.maxinteger - 1, 1, {})",
             "table.concat({}, '', 1, 1e15)",
             "table.concat(setmetatable({}, {__index = rawlen}), '', 1, 1e15)",
             "table.unpack({}, 1, 1e15)",
             "local t = {} for i = 1, 1e4 do t[i] = i end while true do table.insert(t, 1, 0) table.remove(t, 1) end",
             "local t, s = {}, ('x'):rep(1e5) for i = 1, 1000 do t[i] = s end while true do table.sort(t) end",
             "local t = {} for i = 1, 1000 do t[i] = i end while true do table.sort(t) end",
             "local t = {} for i = 1, 1000 do t[i] = i end while true do for k in pairs(t) do break end end",
             "local t = {} for i = 1, 1000 do t[i] = i end while true do next(t) end",
             "while true do tonumber((' '):rep(1e5)) end",
             "while true do utf8.len(('x'):rep(1e5)) end",
             "while true do collectgarbage() end",
             "while true do scene.find(('x'):rep(1000)) end",
         }) {
        const std::string message = stopped(text);
        EXPECT_TRUE(message.ends_with(too_many_steps)) << text << "\n" << message;
    }
}

TEST_F(SandboxTest, LengthsThatLieAreRefused) {
    EXPECT_EQ(answer("table.insert(setmetatable({}, {__len = function() return 1e15 end}), 1, 1)"),
              "fox.lua:1: a list with a length of its own");
}

/// Counting does not see what one instruction costs here; the clock does.
TEST_F(SandboxTest, TimeIsBoundedWhereStepsDoNotShow) {
    ScriptLimits limits;
    limits.seconds = 0.2;
    limits.steps = 1'000'000'000;
    world().set_resource(limits);
    run("local a, b = ('x'):rep(1e6), ('x'):rep(1e6)\nwhile a == b do end");
    ASSERT_EQ(errors().size(), 1u);
    EXPECT_EQ(errors()[0].message, "fox.lua:2: the script takes too long");
}

TEST_F(SandboxTest, DeepRecursionIsAnErrorOfTheScript) {
    run("local function f() return 1 + f() end\nf()");
    ASSERT_EQ(errors().size(), 1u);
    EXPECT_EQ(errors()[0].line, 1);
    EXPECT_TRUE(errors()[0].message.find("stack overflow") != std::string::npos ||
                errors()[0].message.find("more than") != std::string::npos)
        << errors()[0].message;
    world().resource_mutable<ScriptErrors>().errors.clear();
    run("local function f() return (string.gsub('a', 'a', f)) end\nf()");
    ASSERT_EQ(errors().size(), 1u);
    EXPECT_NE(errors()[0].message.find("C stack overflow"), std::string::npos) << errors()[0].message;
    run("local t = {} for i = 1, 1000 do t = setmetatable({}, {__index = t}) end return t.x");
    EXPECT_EQ(errors().size(), 1u);
}

TEST_F(SandboxTest, DeeplyNestedTextIsAnErrorOfTheScript) {
    run("x = " + std::string(10000, '(') + "1" + std::string(10000, ')'));
    ASSERT_EQ(errors().size(), 1u);
    EXPECT_EQ(errors()[0].message, "fox.lua: C stack overflow") << "where in it, Lua does not say";
}

TEST_F(SandboxTest, MemoryComesBackWhenAScriptStops) {
    for (int i = 0; i < 4; ++i)
        EXPECT_NE(
            stopped("t = {} s = ('x'):rep(1e5) for i = 1, 1e9 do t[i] = s .. i end").find("more than 8388608 bytes"),
            std::string::npos);
}

TEST_F(SandboxTest, TheStepsAreThoseOfAFrame) {
    ScriptLimits limits;
    limits.steps = 100'000;
    world().set_resource(limits);
    const Entity fox = add("function update() for i = 1, 20000 do end self.probe.count = self.probe.count + 1 end");
    for (int i = 0; i < 20; ++i) app.run_frame(0);
    EXPECT_EQ(probe(fox).count, 20);
}

TEST_F(SandboxTest, OrdinaryErrorsAreCaught) {
    EXPECT_EQ(answer(R"(
        local ok, message = pcall(error, 'a')
        assert(not ok and message == 'a')
        local ok, a, b = pcall(function(...) return ... end, 1, 2)
        assert(ok and a == 1 and b == 2)
        assert(select('#', pcall(function() end)) == 1)
        local ok, message = xpcall(function(x) error(x, 0) end, function(m) return m .. '!' end, 'no')
        assert(not ok and message == 'no!')
        assert(select(2, xpcall(function(...) return select('#', ...) end, print, 1, nil, 3)) == 3)
        local co = coroutine.create(function(a) local b = coroutine.yield(a + 1) pcall(coroutine.yield, b) error('e', 0) end)
        local r = {}
        for i = 1, 4 do r[i] = tostring(select(2, coroutine.resume(co, i))) end
        assert(table.concat(r, ' ') == '2 2 e cannot resume dead coroutine', table.concat(r, ' '))
        local gen = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(i) end end)
        assert(gen() == 1 and gen() == 2 and coroutine.isyieldable() == false)
        self.probe.text = 'fine')"),
              "fine");
}

} // namespace
} // namespace hachure::test
