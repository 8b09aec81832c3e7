#include <hachure/runtime/assets/stripe_cache.h>
#include <hachure/runtime/assets/stripe_file.h>

namespace hachure::assets {

geometry::StripeMesh cached_stripe_mesh(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                        std::span<const std::uint32_t> indices,
                                        const geometry::StripeSettings& settings,
                                        const std::optional<std::filesystem::path>& folder, std::uintmax_t limit) {
    if (!folder) return geometry::make_stripe_mesh(positions, normals, indices, settings);
    const FolderCache cache(*folder / "stripes", limit);
    const StripeKey key = stripe_key(positions, normals, indices, settings);
    const std::string name = stripe_file_name(key);
    if (const auto bytes = cache.load(name, most_stripe_file_bytes(positions.size(), indices.size())))
        if (auto mesh = read_stripe_file(*bytes, key, positions.size(), indices)) return *std::move(mesh);
    geometry::StripeMesh mesh = geometry::make_stripe_mesh(positions, normals, indices, settings);
    cache.store(name, stripe_file_bytes(key, mesh));
    return mesh;
}

} // namespace hachure::assets
