#include <hachure/components/transform.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/systems/transform/transform.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <random>

namespace hachure {
namespace {

class TransformTest : public ::testing::Test {
protected:
    TransformTest() { register_transform(app); }

    static Transform random_transform(std::mt19937& random) {
        std::normal_distribution<float> normal;
        std::uniform_real_distribution<float> size(0.5f, 1.5f);
        Transform t;
        t.translation = {normal(random), normal(random), normal(random)};
        t.rotation = glm::normalize(glm::quat(normal(random), normal(random), normal(random), normal(random)));
        t.scale = {size(random), -size(random), size(random)};
        return t;
    }

    /// The product of all the way up, in double.
    glm::dmat4 expected(Entity entity) const {
        glm::dmat4 result(1.0);
        for (Entity at = entity; at; at = world.parent(at)) {
            glm::dmat4 local(1.0);
            if (const LocalMatrix* matrix = world.find<LocalMatrix>(at))
                local = glm::dmat4(matrix->matrix);
            else if (const Transform* t = world.find<Transform>(at))
                local = glm::translate(glm::dmat4(1.0), glm::dvec3(t->translation)) *
                        glm::mat4_cast(glm::dquat(t->rotation)) * glm::scale(glm::dmat4(1.0), glm::dvec3(t->scale));
            result = local * result;
        }
        return result;
    }

    void expect_all_right(const std::vector<Entity>& entities) {
        for (const Entity entity : entities) {
            const glm::dmat4 wanted = expected(entity);
            const glm::mat4 got = world.get<WorldTransform>(entity).matrix;
            double size = 1.0;
            for (int i = 0; i < 4; ++i) size = std::max(size, glm::length(wanted[i]));
            for (int i = 0; i < 4; ++i)
                ASSERT_LT(glm::distance(glm::dvec4(got[i]), wanted[i]), 1e-5 * size) << "column " << i;
        }
    }

    App app;
    World& world = app.world();
};

TEST_F(TransformTest, FollowsTheProductOfTheHierarchyThroughRandomEdits) {
    std::mt19937 random(5);
    std::vector<Entity> entities;
    for (int i = 0; i < 200; ++i) {
        entities.push_back(world.create_with(random_transform(random)));
        if (i > 3) world.set_parent(entities.back(), entities[random() % static_cast<unsigned>(i)]);
    }
    for (int round = 0; round < 40; ++round) {
        app.run_frame();
        expect_all_right(entities);
        for (int edit = 0; edit < 5; ++edit) {
            const Entity entity = entities[random() % entities.size()];
            switch (random() % 5) {
            case 0:
                world.get_mutable<Transform>(entity) = random_transform(random);
                break;
            case 1:
                world.clear_parent(entity);
                break;
            case 2:
                try {
                    world.set_parent(entity, entities[random() % entities.size()]);
                } catch (const HierarchyCycle&) {
                }
                break;
            case 3:
                world.add(entity, LocalMatrix{glm::mat4(2, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1)});
                break;
            default:
                world.get_mutable<Transform>(entity).translation.x += 1.0f;
                break;
            }
        }
    }
}

TEST_F(TransformTest, TakingAwayAMatrixBringsBackTheTransform) {
    const Entity entity = world.create_with(Transform{.translation = {1, 2, 3}}, LocalMatrix{glm::mat4(2.0f)});
    app.run_frame();
    world.remove<LocalMatrix>(entity);
    app.run_frame();
    expect_all_right({entity});
}

TEST_F(TransformTest, TouchesOnlyTheBranchThatMoved) {
    const Entity root = world.create_with(Transform{});
    const Entity moved = world.create_with(Transform{}), still = world.create_with(Transform{}),
                 leaf = world.create_with(Transform{});
    world.set_parent(moved, root);
    world.set_parent(still, root);
    world.set_parent(leaf, moved);
    app.run_frame();
    const Tick before = world.tick();
    world.advance_tick();
    world.get_mutable<Transform>(moved).translation.x = 2.0f;
    app.run_frame();
    EXPECT_TRUE(world.changed_since<WorldTransform>(moved, before));
    EXPECT_TRUE(world.changed_since<WorldTransform>(leaf, before));
    EXPECT_FALSE(world.changed_since<WorldTransform>(root, before));
    EXPECT_FALSE(world.changed_since<WorldTransform>(still, before));
}

TEST_F(TransformTest, NothingMovedChangesNothing) {
    const Entity entity = world.create_with(Transform{});
    app.run_frame();
    const Tick before = world.last_changed<WorldTransform>();
    static_cast<void>(world.get_mutable<Transform>(entity)); // touched, but the same
    app.run_frame();
    app.run_frame();
    EXPECT_EQ(world.last_changed<WorldTransform>(), before);
}

/// Quadratic work (each node walking up to its root) would take minutes here, linear work a few hundredths of a second.
TEST_F(TransformTest, ADeepChainTakesLinearTime) {
    constexpr int depth = 100'000;
    Entity parent = world.create_with(Transform{}), root = parent;
    for (int i = 1; i < depth; ++i) {
        const Entity child = world.create_with(Transform{.translation = {0.0f, 1.0f, 0.0f}});
        world.set_parent(child, parent);
        parent = child;
    }
    const auto seconds = [&] {
        const auto start = std::chrono::steady_clock::now();
        app.run_frame();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    EXPECT_LT(seconds(), 5.0) << "all nodes are new";
    EXPECT_EQ(world.get<WorldTransform>(parent).matrix[3].y, float(depth - 1));
    world.get_mutable<Transform>(root).translation.x = 3.0f;
    EXPECT_LT(seconds(), 5.0) << "the root moved";
    EXPECT_EQ(world.get<WorldTransform>(parent).matrix[3].x, 3.0f);
    for (auto [entity, transform] : world.query<Transform>()) transform.translation.x = 0.0f;
    EXPECT_LT(seconds(), 5.0) << "all nodes moved";
    EXPECT_EQ(world.get<WorldTransform>(parent).matrix[3].x, 0.0f);
}

} // namespace
} // namespace hachure
