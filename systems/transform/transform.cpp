#include <hachure/components/transform.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/systems/transform/transform.h>

#include <glm/gtc/matrix_transform.hpp>

#include <unordered_set>
#include <utility>
#include <vector>

namespace hachure {
namespace {

/// Every entity, to ask which of these changed.
using Moves = Query<Optional<const Transform>, Optional<const LocalMatrix>, Optional<const Parent>>;

/// Every entity, with what its place follows from, who stands on it, and the place that it has.
using Nodes = Query<Optional<const Transform>, Optional<const LocalMatrix>, Optional<const Children>,
                    Optional<const WorldTransform>>;

/// What is looked up again and again has a query of its own: a look-up costs by the number of terms.
using Parents = Query<const Parent>;

glm::mat4 local_matrix(const Transform* transform, const LocalMatrix* local) {
    if (local) return local->matrix;
    if (!transform) return glm::mat4(1.0f);
    glm::mat4 matrix = glm::mat4_cast(transform->rotation);
    matrix[0] *= transform->scale.x;
    matrix[1] *= transform->scale.y;
    matrix[2] *= transform->scale.z;
    matrix[3] = glm::vec4(transform->translation, 1.0f);
    return matrix;
}

Entity parent_of(const Parents& parents, Entity entity) {
    const auto found = parents.find(entity);
    return found ? std::get<const Parent&>(*found).entity : Entity::null;
}

/// Whether an ancestor moved as well, so that updating that one's branch does it.
bool below_another(const Parents& parents, Entity entity, const std::unordered_set<Entity>& moved) {
    for (Entity at = parent_of(parents, entity); at; at = parent_of(parents, at))
        if (moved.contains(at)) return true;
    return false;
}

/// Writes the places of whole branches. Those that have none yet get theirs after the system, by command.
class Placement {
public:
    Placement(const Nodes& nodes, const Parents& parents, const Query<WorldTransform>& places, Commands& commands)
        : nodes_(nodes), parents_(parents), places_(places), commands_(commands) {}

    void place_branch(Entity root) {
        pending_.assign({{root, world_from_parent(root)}});
        while (!pending_.empty()) {
            const auto [entity, above] = pending_.back();
            pending_.pop_back();
            const auto [self, transform, local, children, placed] = *nodes_.find(entity);
            const glm::mat4 matrix = above * local_matrix(transform, local);
            place(entity, placed, {matrix});
            if (!children) continue;
            for (const Entity child : children->entities) pending_.emplace_back(child, matrix);
        }
    }

private:
    glm::mat4 world_from_parent(Entity entity) const {
        glm::mat4 matrix(1.0f);
        for (Entity at = parent_of(parents_, entity); at; at = parent_of(parents_, at)) {
            const auto [self, transform, local, children, placed] = *nodes_.find(at);
            matrix = local_matrix(transform, local) * matrix;
        }
        return matrix;
    }

    void place(Entity entity, const WorldTransform* before, const WorldTransform& now) {
        if (!before)
            commands_.add(entity, now);
        else if (!(*before == now))
            std::get<WorldTransform&>(*places_.find(entity)) = now;
    }

    const Nodes& nodes_;
    const Parents& parents_;
    const Query<WorldTransform>& places_;
    Commands& commands_;
    std::vector<std::pair<Entity, glm::mat4>> pending_; ///< with the matrix that each stands in
};

void update_transforms(Moves moves, Nodes nodes, Parents parents, Removed<Transform> no_transform,
                       Removed<LocalMatrix> no_matrix, Removed<Parent> no_parent, LastRun last,
                       Query<WorldTransform> places, Commands& commands) {
    std::vector<Entity> list;
    for (const auto& move : moves.changed_since<Transform, LocalMatrix, Parent>(last.tick))
        list.push_back(std::get<Entity>(move));
    // Who lost one of them stands elsewhere, too.
    const auto add_living = [&](const auto& removed) {
        for (const Entity entity : removed)
            if (nodes.contains(entity)) list.push_back(entity);
    };
    add_living(no_transform);
    add_living(no_matrix);
    add_living(no_parent);
    const std::unordered_set<Entity> moved(list.begin(), list.end());
    Placement placement(nodes, parents, places, commands);
    for (const Entity entity : moved)
        if (!below_another(parents, entity, moved)) placement.place_branch(entity);
}

} // namespace

void register_transform(App& app) {
    app.add_component<Transform>();
    app.add_system(Stage::transform, "transform", update_transforms);
}

} // namespace hachure
