#include <hachure/runtime/assets/image_luma.h>
#include <hachure/systems/shade_strokes/shade_density.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hachure {
namespace {

constexpr std::uint32_t density_samples = 16; // of a cell: a picture changes within one

/// A point of a surface: corners and their weights.
struct CornerWeights {
    std::array<std::uint32_t, 3> vertex;
    glm::vec3 weight;

    template <class T> [[nodiscard]] T of(std::span<const T> values) const {
        return weight.x * values[vertex[0]] + weight.y * values[vertex[1]] + weight.z * values[vertex[2]];
    }
};

CornerWeights corners_at(std::span<const std::uint32_t> indices, const SurfacePoint& point) {
    const std::uint32_t* corner = &indices[3 * std::size_t{point.triangle}];
    return {{corner[0], corner[1], corner[2]}, {1.0f - point.u - point.v, point.u, point.v}};
}

/// 1 for what is no number.
float sound_density(float value) { return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 1.0f; }

/// The mean of `at(place)` over points that are spread evenly over each cell: by the share of its area that lies before
/// them, and in the triangle there by the sequence of the plastic number (Roberts 2018, "The unreasonable effectiveness
/// of quasirandom sequences").
template <class At>
void average_over_cells(const ShadeMesh& mesh, const SurfaceMesh& surface, const At& at, std::vector<float>& density) {
    constexpr double a = 0.7548776662466927, b = 0.5698402909980532; // 1 / plastic number and its square
    density.resize(mesh.cell_count());
    for (std::uint32_t c = 0; c < density.size(); ++c) {
        float sum = 0.0f;
        for (std::uint32_t i = 0; i < density_samples; ++i) {
            const double which = (i + 0.5) / density_samples;
            const ShadeCells::Point point =
                mesh.cells.point_in(c, which, std::fmod(0.5 + a * i, 1.0), std::fmod(0.5 + b * i, 1.0));
            sum += sound_density(at(corners_at(surface.indices, mesh.point(point.triangle, point.weight))));
        }
        density[c] = sum / density_samples;
    }
}

/// Between texels; coordinates have their origin at the upper left, as glTF has it.
float brightness_at(const assets::Image& image, const glm::vec2& texcoord) {
    if (!std::isfinite(texcoord.x) || !std::isfinite(texcoord.y)) return 1.0f;
    const glm::vec2 size(static_cast<float>(image.width), static_cast<float>(image.height));
    const glm::vec2 place = glm::fract(texcoord) * size - 0.5f, corner = glm::floor(place), way = place - corner;
    const auto texel = [&](int dx, int dy) {
        const int x = (static_cast<int>(corner.x) + dx + image.width) % image.width;
        const int y = (static_cast<int>(corner.y) + dy + image.height) % image.height;
        return assets::image_luma(image, static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                             static_cast<std::size_t>(x));
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), way.x), glm::mix(texel(0, 1), texel(1, 1), way.x), way.y);
}

} // namespace

void density_by_paint(const ShadeMesh& mesh, const SurfaceMesh& surface, ShadePaintChannel channel,
                      std::vector<float>& density) {
    if (surface.colors.empty()) return density.assign(mesh.cell_count(), 1.0f);
    const auto c = static_cast<glm::length_t>(channel);
    const auto paint = [&](const CornerWeights& at) { return at.of(std::span(surface.colors))[c]; };
    average_over_cells(mesh, surface, paint, density);
}

void density_by_picture(const ShadeMesh& mesh, const SurfaceMesh& surface, const assets::Image& picture,
                        std::vector<float>& density) {
    if (surface.texcoords.empty()) return density.assign(mesh.cell_count(), 1.0f);
    const auto paint = [&](const CornerWeights& at) {
        return brightness_at(picture, at.of(std::span(surface.texcoords)));
    };
    average_over_cells(mesh, surface, paint, density);
}

float PlacedVolume::factor(const glm::vec3& world) const {
    const glm::vec3 place(volume_from_world * glm::vec4(world, 1.0f));
    const glm::vec3 off = glm::abs(place);
    const float distance = volume.shape == ShadeVolumeShape::box ? std::max({off.x, off.y, off.z}) : glm::length(place);
    const float falloff = std::max(volume.falloff, 1e-4f);
    return glm::mix(volume.inside, volume.outside, glm::smoothstep(1.0f - falloff, 1.0f, distance));
}

void density_by_volumes(const ShadeMesh& mesh, std::span<const glm::vec3> positions,
                        std::span<const std::uint32_t> indices, const glm::mat4& world_from_mesh,
                        std::span<const PlacedVolume> volumes, std::vector<float>& density) {
    density.resize(mesh.cell_count());
    for (std::size_t c = 0; c < density.size(); ++c) {
        float sum = 0.0f;
        for (std::size_t i = mesh.first_sample[c]; i < mesh.first_sample[c + 1]; ++i) {
            const glm::vec3 place = corners_at(indices, mesh.samples[i].point).of(positions);
            const glm::vec3 world(world_from_mesh * glm::vec4(place, 1.0f));
            float factor = 1.0f;
            for (const PlacedVolume& volume : volumes) factor *= sound_density(volume.factor(world));
            sum += mesh.samples[i].weight * factor;
        }
        density[c] = sound_density(sum);
    }
}

} // namespace hachure
