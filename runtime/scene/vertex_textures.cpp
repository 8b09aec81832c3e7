#include <hachure/runtime/scene/vertex_textures.h>

#include <unordered_set>
#include <vector>

namespace hachure {
namespace {

gpu::Texture make_texture(std::span<const glm::vec3> values, std::string_view label) {
    constexpr int columns = VertexTextures::columns;
    const int rows = static_cast<int>((values.size() + columns - 1) / columns);
    std::vector<float> texels(4 * static_cast<std::size_t>(rows) * columns);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (int c = 0; c < 3; ++c) texels[4 * i + static_cast<std::size_t>(c)] = values[i][c];
    gpu::Texture texture({columns, rows, gpu::Format::rgba32f}, label);
    texture.upload(std::span<const float>(texels), gpu::RowOrder::bottom_first);
    texture.set_sampling(gpu::Sampling::nearest());
    return texture;
}

} // namespace

const gpu::Texture& VertexTextures::get(Entity entity, std::uint64_t version, std::span<const glm::vec3> values) {
    Entry& entry = entries_[entity];
    if (!entry.texture || entry.version != version) entry = {make_texture(values, label_), version};
    return entry.texture;
}

void VertexTextures::forget_all_but(std::span<const Entity> kept) {
    if (entries_.empty()) return;
    const std::unordered_set<Entity> wanted(kept.begin(), kept.end());
    std::erase_if(entries_, [&](const auto& entry) { return !wanted.contains(entry.first); });
}

} // namespace hachure
