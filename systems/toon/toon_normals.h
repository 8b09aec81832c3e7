#pragma once

#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/components/surface.h>
#include <hachure/components/toon.h>
#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/query.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/systems/toon/abstracted_normals.h>

#include <map>
#include <unordered_map>

namespace hachure {

using ToonSurfaces = Query<const Surface, const Toon, Optional<const Deform>, Optional<const Deformed>>;

/// Keeps the AbstractedNormals of surfaces with a Toon that asks for them. They are computed once per mesh, and carried
/// along where it is skinned; morph targets do not move them.
class ToonNormals {
public:
    void update(const ToonSurfaces& surfaces, const Query<AbstractedNormals>& results, const Removed<Toon>& unwanted,
                const LastRun& last, const MeshStore& store, Commands& commands);

private:
    struct Rest {
        SharedNormals normals;
        std::uint64_t version = 0;
    };
    struct Task {
        Entity entity;
        const SurfaceMesh* mesh;
        AbstractedShapeKey key;
        geometry::SkinMethod method;
        const Deformed* shape; ///< null where nothing is carried
        AbstractedNormals result{};
    };

    void collect(const ToonSurfaces& surfaces, const Query<AbstractedNormals>& results, const LastRun& last,
                 const MeshStore& store, Commands& commands);
    void compute_rest();
    void finish(Task& task);

    std::map<AbstractedShapeKey, Rest> rest_;
    std::unordered_map<Entity, std::shared_ptr<std::vector<glm::vec3>>> carried_;
    std::vector<Task> tasks_;
    std::uint64_t version_ = 0;
};

} // namespace hachure
