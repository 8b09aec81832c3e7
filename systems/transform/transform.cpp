#include <hachure/components/transform.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/systems/transform/transform.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <unordered_set>
#include <vector>

namespace hachure {
namespace {

glm::mat4 local_matrix(const World& world, Entity entity) {
    if (const LocalMatrix* local = world.find<LocalMatrix>(entity)) return local->matrix;
    const Transform* t = world.find<Transform>(entity);
    if (!t) return glm::mat4(1.0f);
    glm::mat4 matrix = glm::mat4_cast(t->rotation);
    matrix[0] *= t->scale.x;
    matrix[1] *= t->scale.y;
    matrix[2] *= t->scale.z;
    matrix[3] = glm::vec4(t->translation, 1.0f);
    return matrix;
}

/// Remembers when it last looked, so that a frame in which nothing moved costs three comparisons.
class TransformSystem {
public:
    void operator()(World& world) {
        const Tick newest = std::max(
            {world.last_changed<Transform>(), world.last_changed<LocalMatrix>(), world.last_changed<Parent>()});
        if (newest <= seen_) return;
        std::vector<Entity> moved;
        collect<Transform>(world, moved);
        collect<LocalMatrix>(world, moved);
        collect<Parent>(world, moved);
        collect_removed<Parent>(world, moved);
        collect_removed<LocalMatrix>(world, moved);
        collect_removed<Transform>(world, moved);
        const std::unordered_set<Entity> all(moved.begin(), moved.end());
        for (const Entity entity : all)
            if (!below_another(world, entity, all)) update(world, entity);
        seen_ = newest;
    }

private:
    template <class C> void collect(World& world, std::vector<Entity>& moved) const {
        for (auto [entity, value] : world.query<const C>().template changed_since<C>(seen_)) moved.push_back(entity);
    }

    /// Who lost a C stands elsewhere, too.
    template <class C> void collect_removed(const World& world, std::vector<Entity>& moved) const {
        for (const Entity entity : world.removed_since<C>(seen_))
            if (world.alive(entity)) moved.push_back(entity);
    }

    /// Whether an ancestor moved as well, so that updating that one's branch does it.
    static bool below_another(const World& world, Entity entity, const std::unordered_set<Entity>& moved) {
        for (Entity at = world.parent(entity); at; at = world.parent(at))
            if (moved.contains(at)) return true;
        return false;
    }

    static void update(World& world, Entity entity) {
        glm::mat4 parent(1.0f);
        for (Entity at = world.parent(entity); at; at = world.parent(at)) parent = local_matrix(world, at) * parent;
        update_branch(world, entity, parent);
    }

    static void update_branch(World& world, Entity root, const glm::mat4& parent) {
        std::vector<std::pair<Entity, glm::mat4>> pending{{root, parent}};
        while (!pending.empty()) {
            const auto [entity, above] = pending.back();
            pending.pop_back();
            const glm::mat4 matrix = above * local_matrix(world, entity);
            world.set_if_different(entity, WorldTransform{matrix});
            for (const Entity child : world.children(entity)) pending.emplace_back(child, matrix);
        }
    }

    Tick seen_ = 0;
};

} // namespace

void register_transform(App& app) {
    app.add_component<Transform>();
    app.add_system(Stage::transform, "transform", TransformSystem{});
}

} // namespace hachure
