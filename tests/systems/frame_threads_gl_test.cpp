// Frames are the same with one thread and with several, in the world and on the screen.

#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/ecs/snapshot.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <vector>

namespace hachure::test {
namespace {

using Place = std::tuple<Entity, WorldTransform, Tick>; ///< with when it last changed
using Drawn = std::tuple<Entity, std::uint32_t, gpu::Rect, std::string_view>;

/// A frame: what systems made of the world, and the picture.
struct Frame {
    std::vector<std::byte> world;
    std::vector<Place> places; ///< in the order of the walk
    View view;
    LightList lights;
    std::vector<Drawn> drawn;
    std::vector<std::byte> pixels;
};

/// A grid of spheres hung on one another, half of them with tones, some with lines, seen by one camera.
class Mobile {
public:
    explicit Mobile(gpu::Context& context) : scene_(context, {96, 64}) {
        for (int i = 0; i < 12; ++i) {
            const float x = static_cast<float>(i % 4) - 1.5f, y = static_cast<float>(i / 4) - 1.0f;
            balls_.push_back(
                scene_.add(surface_mesh(geometry::icosphere(0.45, 2)),
                           {.translation = i == 0 ? glm::vec3(x, y, 0.0f) : glm::vec3(0.2f, y * 0.3f, x)}));
            if (i > 0) world().set_parent(balls_.back(), balls_[static_cast<std::size_t>(i / 2)]);
            if (i % 2 == 0) world().add(balls_.back(), Gooch{});
            if (i % 3 == 0) world().add(balls_.back(), EdgeLines{});
        }
        scene_.add(Camera{}, {.translation = {0.0f, 0.0f, 9.0f}});
        spawn_default_light(world());
    }

    /// Changes of every kind that systems watch for.
    void step(int frame) {
        world().get_mutable<Transform>(balls_[2]).translation.x += 0.25f;
        if (frame == 1) world().remove<EdgeLines>(balls_[0]);
        if (frame == 2) world().destroy(balls_[5]);
        if (frame == 3) world().clear_parent(balls_[4]);
        if (frame == 4) world().remove<Transform>(balls_[3]);
        if (frame == 5) world().add(balls_[1], Gooch{.b = 0.9f});
    }

    Frame draw() {
        Frame frame;
        frame.pixels = scene_.draw().pixels;
        frame.world = save_snapshot(world(), scene_.app().types());
        for (auto [entity, place] : world().query<const WorldTransform>())
            frame.places.emplace_back(entity, place, world().changed_tick<WorldTransform>(entity));
        frame.view = world().resource<View>();
        frame.lights = world().resource<LightList>();
        const DrawList& list = world().resource<DrawList>();
        for (std::size_t i = 0; i < list.items.size(); ++i) {
            const DrawItem& item = list.items[i];
            frame.drawn.emplace_back(item.entity, item.object_id, item.rect, world().resource<DrawClaims>().shading[i]);
        }
        return frame;
    }

private:
    World& world() { return scene_.world(); }

    DrawnScene scene_;
    std::vector<Entity> balls_;
};

std::vector<Frame> frames(gpu::Context& context, int threads) {
    const ThreadLimit limit(threads);
    Mobile mobile(context);
    std::vector<Frame> result;
    for (int i = 0; i < 7; ++i) {
        mobile.step(i);
        result.push_back(mobile.draw());
    }
    return result;
}

using FrameThreadsTest = GlTest;

TEST_P(FrameThreadsTest, AnyNumberGivesTheSameWorldAndPicture) {
    const std::vector<Frame> one = frames(context(), 1), four = frames(context(), 4);
    for (std::size_t i = 0; i < one.size(); ++i) {
        SCOPED_TRACE(i);
        EXPECT_TRUE(one[i].world == four[i].world);
        EXPECT_TRUE(one[i].places == four[i].places);
        EXPECT_TRUE(one[i].view == four[i].view);
        EXPECT_TRUE(one[i].lights == four[i].lights);
        EXPECT_TRUE(one[i].drawn == four[i].drawn);
        EXPECT_TRUE(one[i].pixels == four[i].pixels);
    }
    EXPECT_FALSE(one.front().pixels == one.back().pixels) << "frames that show nothing compare nothing";
}

HACHURE_INSTANTIATE_GL_TESTS(FrameThreadsTest);

} // namespace
} // namespace hachure::test
