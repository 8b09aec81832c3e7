// Damaged programs stop, or run; they harm nothing else.

#include <hachure/tests/support/mutations.h>
#include <hachure/tests/systems/script/script_fixture.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <chrono>
#include <cmath>
#include <random>

namespace hachure::test {
namespace {

/// Something of everything that programs can do.
constexpr std::string_view whole = R"(
local speed, seen, names = 2.5, {}, {"a", "b", c = 1}
local function wave(t, ...) local n = select('#', ...); return math.sin(t * speed) * 0.5 + n * 1e-3 end
function start()
  self.gooch = nil
  self:add("gooch", {b = 0.25})
  for i = 1, 20 do seen[#seen + 1] = string.format("%d:%s", i, ("x"):rep(i)) end
  table.sort(seen, function(a, b) return a > b end)
  local ok, why = pcall(function() error({code = 3}) end)
  local co = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(i) end end)
  self.probe.count = co() + co() + #table.concat(seen, ",")
end
function update(dt)
  local t = time.seconds
  self.transform.translation = vec3(wave(t), wave(t, 1, 2), 0) * 2 + vec3(0, 1, 0):cross(vec3(1, 0, 0))
  self.transform.rotation = quat.axis_angle(vec3(0, 1, 0), t) * quat(0, 0, 0, 1)
  for e, g in scene.query("gooch") do g.b = math.min(1, g.b + dt * 0.01) end
  for k, v in pairs(names) do self.probe.text = tostring(k) .. tostring(v) end
  if input.pressed("space") or random() < 0.5 then scene.send("jump", self) end
  local a, b = ("key = value"):match("^(%w+)%s*=%s*(%w+)$")
  self.probe.text = (a or "none"):gsub("[aeiou]", string.upper) .. (b or "")
  while t > 1e9 do t = t / 2 end
  local other = scene.find("Other")
  if other and other:alive() and other:has("transform") then other.transform.scale = vec3(1, 1, 1) * (1 + dt) end
  goto done
  ::done::
end
function event(name, entity) self.probe.yes = name == "jump" and entity == self end
)";

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

constexpr std::string_view words[] = {
    "end",
    "function",
    "while true do",
    "self",
    "nil",
    "(",
    ")",
    "{",
    "}",
    "1e308",
    "-1",
    "0/0",
    "[[",
    "]]",
    "--[==[",
    "\"",
    "..",
    "#",
    "pairs",
    "pcall",
    "coroutine",
    "return",
    "scene",
    "math.huge",
    "1 << 63",
    "\\u{7fffffff}",
    "%",
    "goto x",
    "...",
    "load",
    "os",
    "string.rep",
    "setmetatable",
    "getmetatable(\"\")",
    "_G",
    "_ENV",
    "for i = 1, 1e18 do end",
    "self:destroy()",
    "scene.spawn(\"../x.glb\")",
    "error(error)",
    "tostring",
    "update(dt)",
};

void damage(std::string& text, Random& random) {
    const std::size_t at = below(random, text.size());
    switch (below(random, 6)) {
    case 0:
        text[at] = static_cast<char>(random());
        break;
    case 1:
        text.erase(at, 1 + below(random, 20));
        break;
    case 2:
        text.insert(at, text.substr(below(random, text.size()), 1 + below(random, 60)));
        break;
    case 3:
        text.insert(at, fmt::format(" {} ", words[below(random, std::size(words))]));
        break;
    case 4: { // a word in another's place
        const std::size_t begin = text.find_first_of("abcdefghijklmnopqrstuvwxyz", at);
        if (begin == text.npos) break;
        const std::size_t end = std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", begin), text.size());
        text.replace(begin, end - begin, words[below(random, std::size(words))]);
        break;
    }
    default:
        text.resize(std::max<std::size_t>(at, 1));
    }
}

std::string mutated(std::uint64_t seed) {
    Random random(seed);
    std::string text(whole);
    for (std::size_t n = 1 + below(random, 4); n > 0; --n) damage(text, random);
    return text;
}

struct Outcome {
    bool stopped = false;
    double seconds = 0.0;
};

/// Three frames of a damaged program, in a world that holds another entity.
Outcome run_damaged(const TempFolder& folder, std::uint64_t seed) {
    App app;
    register_script(app);
    app.add_component<Name>();
    app.add_component<Transform>();
    app.add_component<Gooch>();
    app.add_component<Probe>();
    World& world = app.world();
    world.set_resource(ScriptLimits{.memory = 4 << 20, .steps = 50'000});
    const std::string file = folder.write(fmt::format("fox{}.lua", seed), mutated(seed)).string();
    world.create_with(Name{"Fox"}, Script{.file = file}, Probe{}, Transform{});
    world.create_with(Name{"Other"}, Transform{}, Gooch{});
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; frame < 3; ++frame) app.run_frame(0.25);
    Outcome outcome;
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const ScriptError& error : world.resource<ScriptErrors>().errors) {
        EXPECT_EQ(error.message.find('\n'), error.message.npos) << seed;
        EXPECT_NE(error.message.find("fox"), error.message.npos) << seed << ": " << error.message;
        outcome.stopped = true;
    }
    for (auto [entity, transform] : world.query<const Transform>()) {
        EXPECT_TRUE(std::isfinite(glm::dot(transform.translation, transform.scale))) << seed;
        EXPECT_NEAR(glm::length(transform.rotation), 1.0f, 2e-3f) << seed;
    }
    std::filesystem::remove(file);
    return outcome;
}

TEST(ScriptMutations, StopOrRun) {
    const TempFolder folder;
    int stopped = 0;
    double slowest = 0.0;
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(mutation_count()); ++seed) {
        const Outcome outcome = run_damaged(folder, seed);
        stopped += outcome.stopped;
        slowest = std::max(slowest, outcome.seconds);
    }
    EXPECT_TRUE(folder.listing().empty()) << "something was written";
    EXPECT_LT(slowest, 5.0);
    EXPECT_GT(stopped, mutation_count() / 4) << "the damage does nothing";
    EXPECT_LT(stopped, mutation_count()) << "the program does not run at all";
}

} // namespace
} // namespace hachure::test
