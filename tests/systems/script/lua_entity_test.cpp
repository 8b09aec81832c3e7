#include <hachure/tests/systems/script/script_fixture.h>

namespace hachure::test {
namespace {

TEST_F(ScriptTest, EveryKindOfFieldIsReadAndWritten) {
    const Entity fox = run(R"(
        local p = self.probe
        p.yes = true; p.count = -3; p.many = 5; p.size = 0.5; p.exact = 0.1
        p.two = vec2(1, 2); p.three = vec3(1, 2, 3); p.four = {1, 2, 3, 4}
        p.turn = quat.axis_angle(vec3(0, 2, 0), math.pi); p.tint = vec3(1, 0, 0)
        p.text = 'hello'; p.mood = 'cross'; p.target = self
        assert(p.yes == true and p.count == -3 and p.many == 5 and p.size == 0.5 and p.exact == 0.1)
        assert(math.type(p.count) == 'integer')
        assert(p.two == vec2(1, 2) and p.three == vec3(1, 2, 3) and p.four == vec4(1, 2, 3, 4))
        assert(math.abs(p.turn.y - 1) < 1e-6 and p.tint.r == 1)
        assert(p.text == 'hello' and p.mood == 'cross' and p.target == self))");
    ASSERT_TRUE(errors().empty()) << errors()[0].message;
    EXPECT_TRUE(probe(fox).yes);
    EXPECT_EQ(probe(fox).count, -3);
    EXPECT_EQ(probe(fox).many, 5u);
    EXPECT_EQ(probe(fox).size, 0.5f);
    EXPECT_EQ(probe(fox).exact, 0.1);
    EXPECT_EQ(probe(fox).four, glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(probe(fox).tint, glm::vec3(1, 0, 0));
    EXPECT_EQ(probe(fox).mood, Probe::Mood::cross);
    EXPECT_EQ(probe(fox).target, fox);
}

TEST_F(ScriptTest, AWrongValueNamesFieldAndFaultAndChangesNothing) {
    const std::pair<const char*, const char*> wrong[] = {
        {"self.probe.size = 2", "fox.lua:1: probe.size: 2 is outside [0, 1]"},
        {"self.probe.size = 'x'", "fox.lua:1: probe.size: a string is no real"},
        {"self.probe.size = 0/0", "fox.lua:1: probe.size: the number is not finite"},
        {"self.probe.count = 1.5", "fox.lua:1: probe.count: 1.5 is no whole number"},
        {"self.probe.count = -11", "fox.lua:1: probe.count: -11 is outside [-10, 1000000000]"},
        {"self.probe.many = -1", "fox.lua:1: probe.many: -1 is below 0"},
        {"self.probe.three = vec2(1, 2)", "fox.lua:1: probe.three: 2 numbers are no vec3"},
        {"self.probe.three = 1", "fox.lua:1: probe.three: a number is no vec3"},
        {"self.probe.turn = {0, 0, 0, 2}", "fox.lua:1: probe.turn: a rotation is a quaternion of length 1"},
        {"self.probe.mood = 'sad'", "fox.lua:1: probe.mood: \"sad\" is none of calm, cross"},
        {"self.probe.target = 1", "fox.lua:1: probe.target: a number is no entity"},
        {"self.probe.yes = 1", "fox.lua:1: probe.yes: a number is no boolean"},
        {"self.probe.nothing = 1", "fox.lua:1: probe has no field nothing"},
        {"local x = self.probe.nothing", "fox.lua:1: probe has no field nothing"},
        {"local x = self.nothing", "fox.lua:1: there is no component nothing"},
        {"self.gooch = 1",
         "fox.lua:1: gooch can't be assigned: assign to a field, as in e.gooch.b = 0.5, or e:add(...)"},
        {"self:add('gooch', {b = 2})", "fox.lua:1: gooch.b: 2 is outside [0, 1]"},
        {"self:add('gooch', {c = 2})", "fox.lua:1: gooch has no field c"},
        {"self:add('gouache')", "fox.lua:1: there is no component gouache"},
        {"self.has('gooch')", "fox.lua:1: bad argument #1 to 'has' (an entity is needed (is it called with a colon?))"},
    };
    for (const auto& [text, message] : wrong) {
        const Entity fox = run(text);
        ASSERT_FALSE(errors().empty()) << text;
        EXPECT_EQ(errors().back().message, message) << text;
        EXPECT_EQ(probe(fox).size, 0.0f);
        EXPECT_FALSE(world().has<Gooch>(fox)) << "neither by halves";
        world().resource_mutable<ScriptErrors>().errors.clear();
        world().destroy(fox);
    }
}

TEST_F(ScriptTest, OnlyWhatDiffersIsMarkedChanged) {
    const Entity fox = add("function update() self.probe.size = 0.25; self.transform.scale = vec3(2) end");
    app.run_frame(0);
    const Tick probe_changed = world().changed_tick<Probe>(fox), scaled = world().changed_tick<Transform>(fox);
    app.run_frame(0);
    EXPECT_EQ(world().changed_tick<Probe>(fox), probe_changed);
    EXPECT_EQ(world().changed_tick<Transform>(fox), scaled);
    EXPECT_EQ(world().get<Transform>(fox).scale, glm::vec3(2));
    world().get_mutable<Probe>(fox).size = 0.5f;
    app.run_frame(0);
    EXPECT_EQ(probe(fox).size, 0.25f);
    EXPECT_GT(world().changed_tick<Probe>(fox), probe_changed);
}

TEST_F(ScriptTest, ComponentsComeAndGo) {
    const Entity fox = run(R"(
        assert(not self:has('gooch') and self.gooch == nil)
        local g = self:add('gooch', {b = 0.5, printed_equation = true})
        assert(g.b == 0.5 and self:has('gooch') and self.gooch.b == 0.5 and self.gooch.y > 0.39)
        self:add('gooch', {y = 0.25})
        assert(g.b == 0.5 and g.y == 0.25)
        assert(self:remove('gooch') and not self:remove('gooch'))
        local ok, message = pcall(function() return g.b end)
        assert(not ok and message == 'fox.lua:8: the entity has no gooch any more', message)
        self:add('gooch'))");
    ASSERT_TRUE(errors().empty()) << errors()[0].message;
    EXPECT_EQ(world().get<Gooch>(fox), Gooch());
}

TEST_F(ScriptTest, TheTreeCanBeReadAndChanged) {
    const Entity ship = world().create_with(Name{"Ship"}), mast = world().create_with(Name{"Mast"});
    world().set_parent(mast, ship);
    const Entity fox = run(R"(
        local ship, mast = scene.find('Ship'), scene.find('Ship/Mast')
        assert(mast.parent == ship and ship.parent == nil)
        assert(#ship.children == 1 and ship.children[1] == mast and #mast.children == 0)
        self.parent = ship
        assert(self.parent == ship and ship.children[2] == self)
        self.name = 'Captain'
        assert(self.name == 'Captain' and scene.find('Ship/Captain') == self)
        local ok, message = pcall(function() ship.parent = mast end)
        assert(not ok and message:find('^fox.lua:9: '), message)
        mast.parent = nil
        assert(mast.parent == nil))");
    ASSERT_TRUE(errors().empty()) << errors()[0].message;
    EXPECT_EQ(world().parent(fox), ship);
    EXPECT_EQ(world().parent(mast), Entity::null);
    EXPECT_EQ(world().get<Name>(fox).text, "Captain");
}

TEST_F(ScriptTest, TheDeadAreRecognised) {
    const Entity other = world().create_with(Name{"Other"}, Gooch{});
    const Entity fox = add(R"(
        other = scene.find('Other')
        held = other.gooch
        self.probe.target = other
        assert(other:alive() and other:destroy() and not other:alive() and not other:destroy())
        assert(self.probe.target == other, 'a handle outlives what it names')
        for _, f in ipairs{function() return other.name end, function() return held.b end,
                           function() held.b = 1 end, function() other:add('gooch') end,
                           function() other.parent = self end, function() self.parent = other end} do
            local ok, message = pcall(f)
            assert(not ok and message:find('not alive'), message)
        end)");
    app.run_frame(0);
    EXPECT_TRUE(errors().empty()) << errors()[0].message;
    EXPECT_FALSE(world().alive(other));
    // The slot is used again, by somebody else.
    world().create_with(Name{"New"});
    folder.write("two.lua", "");
    static_cast<void>(fox);
}

/// The hot path: no garbage.
TEST_F(ScriptTest, ReachingNumbersAllocatesNothing) {
    EXPECT_EQ(answer(R"(
        self:add('gooch')
        local function work()
            for i = 1, 1000 do
                self.gooch.b = self.gooch.y * 0.5
                self.probe.count = self.probe.count + 1
                self.probe.yes = not self.probe.yes
                self.probe.mood = self.probe.mood == 'calm' and 'cross' or 'calm'
                self.probe.target = self.probe.target == nil and self or nil
            end
        end
        work()
        collectgarbage()
        local before = collectgarbage('count')
        work()
        assert(collectgarbage('count') == before, collectgarbage('count') - before)
        self.probe.text = 'none')"),
              "none");
}

TEST_F(ScriptTest, AnEntityIsTheSameValueAndAKey) {
    EXPECT_EQ(answer(R"(
        local set = {}
        set[self] = 1
        collectgarbage()
        assert(set[scene.find('Fox')] == 1 and scene.find('Fox') == self and rawequal(self, scene.find('Fox')))
        self.probe.text = tostring(self))"),
              "Fox");
}

} // namespace
} // namespace hachure::test
