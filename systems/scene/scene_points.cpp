#include <hachure/components/animation.h>
#include <hachure/components/rig.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/scene/clip_store.h>
#include <hachure/systems/model/clip_points.h>
#include <hachure/systems/scene/scene_points.h>

#include <glm/gtc/matrix_transform.hpp>

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace hachure {
namespace {

/// With more points than these in all, boxes do.
constexpr std::size_t max_points = 300'000;

using Key = std::pair<std::string, std::string>; ///< model and clip

class Points {
public:
    Points(const World& world, SceneCache& cache) : world_(world), cache_(cache) {}

    void add(Entity entity, const std::filesystem::path& file) {
        const glm::mat4 place = world_from(entity);
        const std::vector<glm::vec3>& points = points_of(entity, file);
        if (points.size() + result.size() <= max_points) return take(points, place);
        const geometry::Bounds bounds = geometry::bounds_of(points);
        if (bounds.empty()) return;
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 8; ++i)
            corners.emplace_back((i & 1) != 0 ? bounds.high.x : bounds.low.x,
                                 (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                                 (i & 4) != 0 ? bounds.high.z : bounds.low.z);
        take(corners, place);
    }

    std::vector<glm::vec3> result;

private:
    void take(const std::vector<glm::vec3>& points, const glm::mat4& place) {
        for (const glm::vec3& point : points) result.emplace_back(place * glm::vec4(point, 1.0f));
    }

    glm::mat4 world_from(Entity entity) const {
        glm::mat4 matrix(1.0f);
        for (; entity; entity = world_.parent(entity))
            if (const Transform* t = world_.find<Transform>(entity))
                matrix = glm::translate(glm::mat4(1.0f), t->translation) * glm::mat4_cast(t->rotation) *
                         glm::scale(glm::mat4(1.0f), t->scale) * matrix;
        return matrix;
    }

    const std::vector<glm::vec3>& points_of(Entity entity, const std::filesystem::path& file) {
        SceneCache::CachedModel& cached = cache_.model(file);
        const Animation* animation = world_.find<Animation>(entity);
        const Rig* rig = world_.find<Rig>(entity);
        if (!animation || !rig) return *cached.stored.points;
        const animation::ClipSet& set = world_.resource<ClipStore>().clips(rig->clips).set;
        const auto clip = animation::find_clip(set, animation->clip);
        if (!clip) return *cached.stored.points;
        const auto [entry, fresh] = moving_.try_emplace({canonical_path(file), animation->clip});
        if (fresh) entry->second = clip_points(cached.model, set, set.clips[*clip]);
        return entry->second;
    }

    const World& world_;
    SceneCache& cache_;
    std::map<Key, std::vector<glm::vec3>> moving_;
};

} // namespace

std::vector<glm::vec3> scene_points(const World& world, SceneCache& cache, const BuiltScene& scene) {
    Points points(world, cache);
    for (const auto& [entity, file] : scene.models) points.add(entity, file);
    return std::move(points.result);
}

} // namespace hachure
