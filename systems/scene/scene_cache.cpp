#include <hachure/components/scene.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/systems/scene/scene_cache.h>

#include <system_error>
#include <utility>

namespace hachure {

std::string canonical_path(const std::filesystem::path& file) {
    std::error_code error;
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(std::filesystem::absolute(file), error);
    return error ? file.lexically_normal().string() : canonical.string();
}

SceneCache::CachedModel& SceneCache::model(const std::filesystem::path& file) {
    const std::string key = canonical_path(file);
    if (const auto found = models_.find(key); found != models_.end()) return found->second;
    CachedModel cached;
    cached.model = assets::read_model(file);
    for (const std::string& warning : cached.model.warnings) cached.warnings.push_back(file.string() + ": " + warning);
    return models_.emplace(key, std::move(cached)).first->second;
}

std::shared_ptr<const SceneFile> SceneCache::scene(const std::filesystem::path& file) {
    const std::string key = canonical_path(file);
    if (const auto found = scenes_.find(key); found != scenes_.end()) return found->second;
    return scenes_.emplace(key, std::make_shared<const SceneFile>(SceneFile::read(file))).first->second;
}

SpawnedModel SceneCache::spawn(World& world, const std::filesystem::path& file) {
    CachedModel& cached = model(file);
    SpawnedModel spawned = spawn_model(world, cached.model, cached.stored);
    if (!cached.spawned)
        for (const std::string& warning : spawned.warnings) cached.warnings.push_back(file.string() + ": " + warning);
    cached.spawned = true;
    world.for_each_descendant(spawned.root, [&](Entity entity) { world.add(entity, Unsaved{}); });
    return spawned;
}

Entity SceneCache::spawn_copy(World& world, const std::filesystem::path& file) {
    CachedModel& cached = model(file);
    // The first one may be the only one, and is not there to be copied: what is said of it changes it.
    if (!cached.spawned) return spawn(world, file).root;
    if (!cached.prototype) cached.prototype = spawn(world, file).root;
    return world.instantiate(cached.prototype);
}

void SceneCache::finish(World& world) {
    for (auto& [key, cached] : models_) {
        if (cached.prototype) world.destroy(cached.prototype);
        cached.prototype = Entity::null;
        if (!cached.spawned) continue;
        for (assets::Mesh& mesh : cached.model.meshes)
            for (assets::Primitive& primitive : mesh.primitives) primitive = {};
        cached.model.images.clear();
    }
}

} // namespace hachure
