#include <hachure/runtime/app/input.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/spawner.h>
#include <hachure/tests/systems/script/script_fixture.h>

namespace hachure::test {
namespace {

TEST_F(ScriptTest, FindsByPathsOfNames) {
    const Entity a = world().create_with(Name{"Tree"}), b = world().create_with(Name{"Tree"});
    const Entity leaf = world().create_with(Name{"Leaf"});
    world().set_parent(leaf, b);
    EXPECT_EQ(answer(R"(
        local all = scene.find_all('Tree')
        assert(#all == 2 and all[1] == scene.find('Tree') and scene.find('Tree/Leaf').parent == all[2])
        assert(scene.find('Nobody') == nil and #scene.find_all('Nobody') == 0)
        self.probe.text = 'found')"),
              "found");
    static_cast<void>(a);
}

TEST_F(ScriptTest, QueriesWalkInOrderOfSlots) {
    std::vector<Entity> all;
    for (int i = 0; i < 5; ++i) all.push_back(world().create_with(Name{std::to_string(i)}, Gooch{}));
    world().add(all[1], Transform{}); // moves to another table
    world().add(all[3], Transform{});
    EXPECT_EQ(answer(R"(
        local text = ''
        for e in scene.query('gooch') do text = text .. e.name end
        for e, g, t in scene.query('gooch', 'transform') do
            text = text .. ' ' .. e.name .. tostring(g) .. tostring(t)
            assert(g.b == e.gooch.b and t.scale == vec3(1))
        end
        self.probe.text = text)"),
              "01234 1goochtransform 3goochtransform");
}

TEST_F(ScriptTest, StructureMayChangeDuringAQuery) {
    for (int i = 0; i < 100; ++i) world().create_with(Gooch{});
    EXPECT_EQ(answer(R"(
        local n, others, place = 0, {}, {}
        for e in scene.query('gooch') do others[#others + 1] = e; place[e] = #others end
        for e in scene.query('gooch') do
            n = n + 1
            others[place[e] + 1]:destroy()
            e:remove('gooch')
            e:add('transform')
            scene.find('Fox'):add('gooch')
        end
        self.probe.text = tostring(n))"),
              "50");
    EXPECT_EQ(world().query<const Gooch>().count(), 1u);
}

TEST_F(ScriptTest, AWalkThatEndedGivesNothingMore) {
    EXPECT_EQ(
        answer("local walk = scene.query('probe')\nassert(walk() == self)\nassert(walk() == nil and walk() == nil)\n"
               "self.probe.text = 'done'"),
        "done");
}

/// More entities than fit in the memory of scripts at once: those that no script holds are forgotten.
TEST_F(ScriptTest, AWalkMayBeLongerThanMemoryIsLarge) {
    world().create_many(40'000, Gooch{});
    ScriptLimits limits;
    limits.memory = std::size_t{4} << 20;
    world().set_resource(limits);
    const Entity fox = add(R"(function update()
        first = first or scene.query('gooch')()
        local n = 0
        for e, g in scene.query('gooch') do n = n + 1; if e == first then assert(rawequal(e, first)) end end
        self.probe.count = self.probe.count + n
    end)");
    for (int i = 0; i < 3; ++i) app.run_frame(0);
    EXPECT_TRUE(errors().empty()) << errors()[0].message;
    EXPECT_EQ(probe(fox).count, 120'000);
}

TEST_F(ScriptTest, FieldsAreThoseOfTheEntityWhereverItMoved) {
    const Entity other = world().create_with(Name{"Other"}, Gooch{});
    const Entity fox = add(R"(
        local g = scene.find('Other').gooch
        function update()
            g.b = 0.125
            scene.find('Other'):add('transform')
            self.name = 'x'
            local before = g.b
            g.b = 0.25
            scene.find('Other'):remove('transform')
            self.probe.two = vec2(before, g.b)
        end)");
    for (int i = 0; i < 2; ++i) {
        app.run_frame(0);
        EXPECT_EQ(probe(fox).two, glm::vec2(0.125, 0.25));
        EXPECT_EQ(world().get<Gooch>(other).b, 0.25f);
        world().create_with(Name{"Between"}, Gooch{}); // moves what stands beside it
        world().add(other, Probe{});
    }
    EXPECT_TRUE(errors().empty());
}

TEST_F(ScriptTest, WrongQueriesSayWhy) {
    EXPECT_EQ(answer("scene.query()"), "fox.lua:1: scene.query takes the names of 1 to 8 components");
    EXPECT_EQ(answer("scene.query('gooch', 'gouache')"), "fox.lua:1: there is no component gouache");
}

TEST_F(ScriptTest, SpawnsThroughTheSpawner) {
    world().set_resource(Spawner{[](World& world, const SpawnRequest& request) {
        if (request.what == "bad.glb") throw Error("bad.glb", "it is broken");
        const Entity made = world.create_with(Name{request.name.empty() ? request.what : request.name}, Transform{});
        if (request.parent) world.set_parent(made, request.parent);
        return made;
    }});
    EXPECT_EQ(answer(R"(
        local a = scene.spawn('tree.glb')
        local b = scene.spawn('tree.glb', {name = 'Oak', parent = self})
        b.transform.translation = {1, 2, 3}
        assert(a.name == 'tree.glb' and b.name == 'Oak' and b.parent == self)
        local ok, message = pcall(scene.spawn, 'bad.glb')
        self.probe.text = message)"),
              "bad.glb: it is broken");
    EXPECT_EQ(answer("\nscene.spawn('bad.glb')"), "fox.lua:2: bad.glb: it is broken");
}

TEST_F(ScriptTest, WithoutASpawnerThereIsAnError) {
    EXPECT_EQ(answer("scene.spawn('x')"), "fox.lua:1: scene.spawn: this program has nothing to spawn from");
}

TEST_F(ScriptTest, InputIsThatOfTheFrame) {
    const Entity fox = add(R"(function update()
        self.probe.text = (input.down('space') and 'd' or '-') .. (input.pressed('space') and 'p' or '-') ..
            (input.released('space') and 'r' or '-') .. (input.button('left') and 'b' or '-')
        self.probe.two = input.pointer + input.scroll
    end)");
    Input& input = world().set_resource(Input{});
    const auto frame = [&](std::vector<InputEvent> events) {
        input.take(events);
        app.run_frame(0);
        return probe(fox).text;
    };
    EXPECT_EQ(frame({}), "----");
    EXPECT_EQ(frame({{InputKind::key_down, "space", {}}, {InputKind::button_down, "left", {}}}), "dp-b");
    EXPECT_EQ(frame({}), "d--b");
    EXPECT_EQ(frame({{InputKind::key_up, "space", {}}, {InputKind::pointer_move, "", {10, 20}}}), "--rb");
    EXPECT_EQ(probe(fox).two, glm::vec2(10, 20));
    frame({{InputKind::scroll, "", {0, 2}}});
    EXPECT_EQ(probe(fox).two, glm::vec2(10, 22));
    EXPECT_TRUE(errors().empty());
}

TEST_F(ScriptTest, WithoutInputNothingIsDown) {
    EXPECT_EQ(value("input.down('space') or input.pointer"), "vec2(0, 0)");
}

} // namespace
} // namespace hachure::test
