// What replaces functions of Lua's library works as they do, and in the same order each time.

#include <hachure/tests/systems/script/script_fixture.h>

#include <fmt/format.h>

namespace hachure::test {
namespace {

TEST_F(ScriptTest, PairsWalksInOrder) {
    EXPECT_EQ(
        answer(R"(
        local t = {30, 20, 10, b = 1, a = 2, [true] = 3, [1.5] = 4, [-7] = 5, [self] = 6, [math.maxinteger] = 7,
                   [math.maxinteger - 1] = 8, [2^63] = 9, B = 10}
        local text = ''
        for k, v in pairs(t) do text = text .. tostring(k) .. '=' .. v .. ' ' end
        local again, k, v = '', next(t)
        while k ~= nil do again = again .. tostring(k) .. '=' .. v .. ' '; k, v = next(t, k) end
        assert(again == text, again)
        assert(next({}) == nil)
        self.probe.text = text)"),
        "-7=5 1=30 1.5=4 2=20 3=10 9223372036854775806=8 9223372036854775807=7 9.2233720368548e+18=9 B=10 a=2 b=1 "
        "true=3 Fox=6 ");
}

TEST_F(ScriptTest, KeysMayGoWhilePairsWalks) {
    EXPECT_EQ(answer(R"(
        local t, n = {a = 1, b = 2, c = 3, d = 4}, 0
        for k in pairs(t) do n = n + 1; t[k] = nil; t.c = nil end
        assert(next(t) == nil)
        self.probe.text = tostring(n))"),
              "3");
    EXPECT_EQ(value("(function() local n = 0 for k in pairs({[{}] = 1}) do n = n + 1 end return n end)()"), "1");
    EXPECT_EQ(value("(function() for k in pairs(setmetatable({}, {__pairs = function() return next, {x = 1} end})) do "
                    "return k end end)()"),
              "x");
    EXPECT_EQ(answer("for k in pairs({[{}] = 1, [{}] = 2}) do end"),
              "fox.lua:1: keys that are tables or functions have no order");
}

TEST_F(ScriptTest, ManyKeysAreSorted) {
    EXPECT_EQ(answer(R"(
        local t = {}
        for i = 1, 2000 do t['k' .. (i * 7919 % 2003)] = i end
        local before, n = '', 0
        for k in pairs(t) do assert(before < k); before = k; n = n + 1 end
        self.probe.text = tostring(n))"),
              "2000");
}

TEST_F(ScriptTest, NothingShowsAnAddress) {
    EXPECT_EQ(value("{}"), "table");
    EXPECT_EQ(value("print"), "function");
    EXPECT_EQ(value("coroutine.create(print)"), "thread");
    EXPECT_EQ(value("string.format('%s %s %5.1f %%p', {}, self, 1.25)"), "table Fox   1.2 %p");
    EXPECT_EQ(value("setmetatable({}, {__tostring = function() return 'mine' end})"), "mine");
    EXPECT_EQ(value("string.format('%s', setmetatable({}, {__name = 'x'}))"), "table");
    EXPECT_EQ(value("tostring(1) .. tostring(nil) .. tostring(true) .. tostring(1.5)"), "1niltrue1.5");
}

TEST_F(ScriptTest, PatternsMeanWhatTheyDoInLua) {
    const std::pair<const char*, const char*> cases[] = {
        {"('hello world'):find('wor')", "7"},
        {"('hello'):find('l', 1, true)", "3"},
        {"('hello'):find('xyz')", "nil"},
        {"('hello'):find('')", "1"},
        {"('hello'):find('', 10)", "nil"},
        {"('hello'):find('', 6)", "6"},
        {"('a.b'):find('.', 2, true)", "2"},
        {"('hello'):find('l+', -2)", "4"},
        {"table.concat({('key = value'):match('^(%w+)%s*=%s*(%w+)$')}, '|')", "key|value"},
        {"('  trim  '):match('^%s*(.-)%s*$') .. '|'", "trim|"},
        {"('x'):match('()x()')", "1"},
        {"select(2, ('x'):match('()x()'))", "2"},
        {"('f(a(b)c)d'):match('%b()')", "(a(b)c)"},
        {"('THE (quick) fox'):find('%f[%a]%a+%f[%A]')", "1"},
        {"('THE (quick) fox'):match('%f[%l]%a+')", "quick"},
        {"('abcabc'):match('(abc)%1')", "abc"},
        {"('[]]'):match('[]]+')", "]]"},
        {"('a-z'):match('[a%-]+')", "a-"},
        {"('0x1F'):match('^0[xX]%x+$')", "0x1F"},
        {"('abc'):match('[^b]+')", "a"},
        {"('aXb'):match('%u')", "X"},
        {"('a$'):match('a$$')", "a$"},
        {"('a$'):match('a%$$')", "a$"},
        {"('a$b'):match('a$b')", "a$b"},
        {"('color colour'):gsub('colou?r', 'C')", "C C"},
        {"('hello world'):gsub('o', '0', 1)", "hell0 world"},
        {"('hello'):gsub('', '-')", "-h-e-l-l-o-"},
        {"('hello world'):gsub('(%w+) (%w+)', '%2 %1 %0 %%')", "world hello hello world %"},
        {"('$name is $age'):gsub('%$(%w+)', {name = 'Fox', age = 3})", "Fox is 3"},
        {"('abc'):gsub('%w', function(c) return c ~= 'b' and c:upper() end)", "AbC"},
        {"('abc'):gsub('^a', 'x')", "xbc"},
        {"('abc'):gsub('()', '%1')", "1a2b3c4"},
        {"select(2, ('abcabc'):gsub('b', ''))", "2"},
        {"(function() local t = {} for k, v in ('a=1, b=2'):gmatch('(%w+)=(%w+)') do t[#t + 1] = k .. v end "
         "return table.concat(t) end)()",
         "a1b2"},
        {"(function() local n = 0 for w in ('one two'):gmatch('%a*') do n = n + 1 end return n end)()", "2"},
        {"(function() local t = {} for w in ('abc'):gmatch('%w', 2) do t[#t + 1] = w end return table.concat(t) end)()",
         "bc"},
        {"('a\\0b'):find('\\0')", "2"},
        {"('x'):rep(3, ',')", "x,x,x"},
        {"('x'):rep(0) .. ('x'):rep(-1)", ""},
    };
    for (const auto& [expression, expected] : cases)
        EXPECT_EQ(value(fmt::format("({})", expression)), expected) << expression;
}

TEST_F(ScriptTest, MalformedPatternsAreErrors) {
    for (const char* const pattern : {"%", "[a", "[]", "[%", "(a", "[a])", "%b", "%bx", "%f", "%1", "(()%1)"}) {
        EXPECT_EQ(value(fmt::format("pcall(string.find, 'aaa(', '{}')", pattern)), "false") << pattern;
    }
    EXPECT_EQ(value("pcall(string.gsub, 'a', 'a', '%2')"), "false");
    EXPECT_EQ(value("pcall(string.gsub, 'a', 'a', '%x')"), "false");
    EXPECT_EQ(value("pcall(string.gsub, 'a', 'a', true)"), "false");
    EXPECT_EQ(value("pcall(string.rep, 'x', 1 << 40)"), "false");
    EXPECT_EQ(value("pcall(string.find, ('a'):rep(300), ('(a'):rep(33) .. (')'):rep(33))"), "false");
}

TEST_F(ScriptTest, ListsWorkAsInLua) {
    EXPECT_EQ(answer(R"(
        local t = {3, 1, 2}
        table.sort(t) table.insert(t, 4) table.insert(t, 1, 0)
        assert(table.concat(t, ',') == '0,1,2,3,4' and table.remove(t) == 4 and table.remove(t, 1) == 0)
        table.sort(t, function(a, b) return a > b end)
        assert(table.concat(t, '', 2, 3) == '21' and select('#', table.unpack(t)) == 3)
        assert(table.concat(table.move(t, 1, 3, 2)) == '3321' and table.pack(1, nil).n == 2)
        local words = {'b', 'a', 'c'}
        table.sort(words)
        assert(table.concat(words) == 'abc' and utf8.len('äö') == 2 and utf8.char(228) == 'ä')
        assert(tonumber('0x10') == 16 and tonumber('z', 36) == 35 and string.pack('i1', 65) == 'A')
        assert(math.floor(2.5) == 2 and math.max(1, 2) == 2 and ('abc'):byte(-1) == 99 and ('abc'):sub(2) == 'bc')
        for i, v in ipairs(words) do assert(words[i] == v) end
        assert(collectgarbage('count') > 1 and collectgarbage() == 0)
        self.probe.text = _VERSION)"),
              "Lua 5.4");
}

} // namespace
} // namespace hachure::test
