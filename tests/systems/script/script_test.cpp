// When scripts run, and for whom.

#include <hachure/components/animation_events.h>
#include <hachure/components/scene_event.h>
#include <hachure/runtime/ecs/events.h>
#include <hachure/runtime/scene/scene_seed.h>
#include <hachure/tests/systems/script/script_fixture.h>

#include <algorithm>

namespace hachure::test {
namespace {

TEST_F(ScriptTest, StartsOnceAndUpdatesEachFrame) {
    const Entity fox = add(R"(
        function start() self.probe.count = 100 end
        function update(dt) self.probe.count = self.probe.count + 1; self.probe.exact = self.probe.exact + dt end)");
    for (int i = 0; i < 3; ++i) app.run_frame(0.25);
    EXPECT_EQ(probe(fox).count, 103);
    EXPECT_DOUBLE_EQ(probe(fox).exact, 0.75);
    EXPECT_TRUE(errors().empty());
}

TEST_F(ScriptTest, WithoutFunctionsTheFileItselfRuns) {
    EXPECT_EQ(probe(run("self.probe.count = 7")).count, 7);
    EXPECT_TRUE(errors().empty());
}

TEST_F(ScriptTest, EntitiesHaveGlobalsOfTheirOwn) {
    const Entity a = add("n = 0\nfunction update() n = n + 1; self.probe.count = n; string_of_mine = 1 end");
    const Entity b = world().create_with(Script{world().get<Script>(a).file}, Probe{});
    app.run_frame(0);
    world().get_mutable<Script>(b).enabled = false;
    app.run_frame(0);
    EXPECT_EQ(probe(a).count, 2);
    EXPECT_EQ(probe(b).count, 1) << "and is disabled";
    world().get_mutable<Script>(b).enabled = true;
    app.run_frame(0);
    EXPECT_EQ(probe(b).count, 2) << "keeps what it had";
}

TEST_F(ScriptTest, AnotherFileStartsAnew) {
    const Entity fox = run("function update() self.probe.text = 'one' end");
    world().get_mutable<Script>(fox).file = folder.write("two.lua", "self.probe.text = 'two'").string();
    app.run_frame(0);
    EXPECT_EQ(probe(fox).text, "two");
}

TEST_F(ScriptTest, AScriptThatIsGoneIsNotRun) {
    const Entity fox = run("function update() self.probe.count = self.probe.count + 1 end");
    world().remove<Script>(fox);
    app.run_frame(0);
    EXPECT_EQ(probe(fox).count, 1);
    world().add(fox, Script{folder.write("b.lua", "self:destroy() function start() nothing.here = 1 end").string()});
    app.run_frame(0);
    EXPECT_FALSE(world().alive(fox));
    EXPECT_TRUE(errors().empty()) << "start is not called for the dead";
    app.run_frame(0);
}

TEST_F(ScriptTest, EventsAreThoseOfTheEntityOrOfNobody) {
    const Entity fox = add(R"(function event(name, who)
        self.probe.text = self.probe.text .. name .. (who and who.name or '-') .. ' ' end)");
    const Entity other = world().create_with(Name{"Other"});
    const Entity model = world().create_with(Name{"Model"});
    world().set_parent(model, fox);
    send_event(world(), SceneEvent{fox, "mine"});
    send_event(world(), SceneEvent{other, "theirs"});
    send_event(world(), SceneEvent{Entity::null, "all"});
    send_event(world(), ClipEvent{.model = model, .clip = "Run", .name = "step"});
    send_event(world(), ClipEvent{.model = other, .clip = "Run", .name = "no"});
    app.run_frame(0);
    EXPECT_EQ(probe(fox).text, "mineFox all- stepModel ");
    for (int i = 0; i < 3; ++i) app.run_frame(0);
    EXPECT_EQ(probe(fox).text, "mineFox all- stepModel ") << "each event once";
    send_event(world(), SceneEvent{fox, "again"});
    app.run_frame(0);
    EXPECT_EQ(probe(fox).text, "mineFox all- stepModel againFox ");
}

TEST_F(ScriptTest, WhatScriptsSendArrivesInTheNextFrame) {
    const Entity a = add("function start() scene.send('boom') scene.send('you', scene.find('B')) end", "A", "a.lua");
    const Entity b = add("function event(n) self.probe.text = self.probe.text .. n end", "B", "b.lua");
    app.run_frame(0);
    EXPECT_EQ(probe(b).text, "");
    for (int i = 0; i < 3; ++i) app.run_frame(0);
    EXPECT_EQ(probe(b).text, "boomyou");
    EXPECT_TRUE(errors().empty());
    static_cast<void>(a);
}

TEST_F(ScriptTest, AnErrorNamesFileAndLineAndStopsThatScript) {
    testing::internal::CaptureStderr();
    const Entity fox = add("function update()\n  self.probe.count = self.probe.count + 1\n  nothing.here = 1\nend");
    const Entity other = add("function update() self.probe.count = self.probe.count + 1 end", "Other", "other.lua");
    for (int i = 0; i < 3; ++i) app.run_frame(0);
    EXPECT_EQ(probe(fox).count, 1);
    EXPECT_EQ(probe(other).count, 3);
    ASSERT_EQ(errors().size(), 1u);
    EXPECT_EQ(errors()[0].entity, fox);
    EXPECT_EQ(errors()[0].file, world().get<Script>(fox).file);
    EXPECT_EQ(errors()[0].line, 3);
    EXPECT_EQ(errors()[0].message, "fox.lua:3: attempt to index a nil value (global 'nothing')");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "hachure: warning: " + errors()[0].message + "\n");
    EXPECT_TRUE(world().has<Script>(fox)) << "the component stays";
}

TEST_F(ScriptTest, MissingAndWrongFilesAreErrorsToo) {
    testing::internal::CaptureStderr();
    const std::string missing = (folder / "missing.lua").string();
    world().create_with(Script{missing});
    world().create_with(Script{missing});
    add("x = = 1", "Fox", "wrong.lua");
    add("\x1bLua", "Fox", "compiled.lua");
    world().create_with(Script{"/etc/hostname"});
    app.run_frame(0);
    app.run_frame(0);
    ASSERT_EQ(errors().size(), 5u);
    EXPECT_TRUE(errors()[0].message.starts_with("missing.lua: ")) << errors()[0].message;
    EXPECT_EQ(errors()[1].message, errors()[0].message);
    EXPECT_EQ(errors()[2].message, "wrong.lua:1: unexpected symbol near '='");
    EXPECT_EQ(errors()[2].line, 1);
    EXPECT_EQ(errors()[3].message, "compiled.lua: this is compiled, and a script is text");
    EXPECT_EQ(errors()[4].message, "hostname: the name of a script ends with .lua");
    const std::string log = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::ranges::count(log, '\n'), 4) << "the same fault is logged once";
}

TEST_F(ScriptTest, ErrorsInCoroutinesAndOfOtherTypesHaveLines) {
    run("local co = coroutine.wrap(function()\n error('inside')\nend)\nco()");
    run("\nerror({})");
    run("\n\nerror('plain', 0)");
    ASSERT_EQ(errors().size(), 3u);
    EXPECT_TRUE(errors()[0].message.ends_with("inside")) << errors()[0].message;
    EXPECT_GT(errors()[0].line, 0);
    EXPECT_EQ(errors()[1].message, "fox.lua:2: the error is a table and no text");
    EXPECT_EQ(errors()[2].message, "fox.lua:3: plain");
}

TEST_F(ScriptTest, TimeIsThatOfTheSchedule) {
    const Entity fox = add("function update() self.probe.text = time.frame .. ' ' .. time.seconds end");
    for (int i = 0; i < 3; ++i) app.run_frame(0.5);
    EXPECT_EQ(probe(fox).text, "2 1.5");
}

TEST_F(ScriptTest, LogIsALineThatNamesTheFile) {
    testing::internal::CaptureStderr();
    run("log('a', 1, vec3(1, 2, 3), {}, nil, self)\nprint(true)");
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "hachure: note: fox.lua: a 1 vec3(1, 2, 3) table nil Fox\nhachure: note: fox.lua: true\n");
}

/// The numbers of an entity called so, in a world with this seed.
std::string random_numbers(std::uint64_t seed, const std::string& name, int frames) {
    struct Run : ScriptTest {
        void TestBody() override {}
    } run;
    run.world().set_resource(SceneSeed{seed});
    const Entity fox = run.add("function update() self.probe.text = self.probe.text .. random() .. ' ' .. random(6) .. "
                               "' ' .. math.random(-3, 3) .. ' ' end",
                               name);
    for (int i = 0; i < frames; ++i) run.app.run_frame(0.1 * i);
    EXPECT_TRUE(run.errors().empty());
    return run.probe(fox).text;
}

TEST(ScriptRandomTest, DependsOnSeedNameAndCallAlone) {
    const std::string fox = random_numbers(1, "Fox", 5);
    EXPECT_EQ(fox, random_numbers(1, "Fox", 5));
    EXPECT_TRUE(fox.starts_with(random_numbers(1, "Fox", 2)));
    EXPECT_NE(fox, random_numbers(2, "Fox", 5));
    EXPECT_NE(fox, random_numbers(1, "Hare", 5));
}

TEST_F(ScriptTest, RandomNumbersAreEvenAndInRange) {
    EXPECT_EQ(answer(R"(
        local sum, hits = 0, {0, 0, 0, 0, 0, 0}
        for i = 1, 6000 do
            local x = random()
            assert(x >= 0 and x < 1)
            sum = sum + x
            local n = random(6)
            hits[n] = hits[n] + 1
        end
        assert(math.abs(sum / 6000 - 0.5) < 0.02)
        for i = 1, 6 do assert(math.abs(hits[i] - 1000) < 150, hits[i]) end
        assert(random(5, 5) == 5)
        assert(not pcall(random, 2, 1))
        assert(math.type(random(math.mininteger, math.maxinteger)) == 'integer')
        self.probe.text = 'even')"),
              "even");
}

TEST_F(ScriptTest, TwoOfANameHaveNumbersOfTheirOwn) {
    const Entity a = add("self.probe.exact = random()");
    const Entity b = world().create_with(Name{"Fox"}, Script{world().get<Script>(a).file}, Probe{});
    app.run_frame(0);
    EXPECT_NE(probe(a).exact, probe(b).exact);
}

TEST_F(ScriptTest, WhatIsSaidFitsOnALine) {
    const std::string half_a_program(2000, 'x');
    run("local t = {}\nfunction f(a, [[b\nc\n" + half_a_program + "]]) end");
    ASSERT_EQ(errors().size(), 1u);
    EXPECT_EQ(errors().front().message.find('\n'), std::string::npos);
    EXPECT_LT(errors().front().message.size(), 400u);
    EXPECT_NE(errors().front().message.find("b?c?x"), std::string::npos) << errors().front().message;
}

} // namespace
} // namespace hachure::test
