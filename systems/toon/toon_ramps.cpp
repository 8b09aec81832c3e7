#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/toon/toon_ramps.h>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace hachure {
namespace {

std::array<double, 256> make_linear() {
    std::array<double, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double s = static_cast<double>(i) / 255.0;
        table[i] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    }
    return table;
}

glm::dvec3 texel(const assets::Image& image, std::size_t index) {
    static const std::array<double, 256> linear = make_linear();
    const auto channels = static_cast<std::size_t>(image.channels);
    glm::dvec3 color;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t at = index * channels + (channels >= 3 ? c : 0);
        color[static_cast<int>(c)] =
            image.type == assets::PixelType::u8 ? linear[image.u8()[at]] : static_cast<double>(image.f32()[at]);
    }
    return color;
}

} // namespace

RampSums sum_ramp(const assets::Image& image, const std::filesystem::path& file) {
    RampSums sums{image.width, image.height, {}};
    const auto columns = static_cast<std::size_t>(image.width), rows = static_cast<std::size_t>(image.height);
    sums.texels.reserve(4 * rows * (columns + 1));
    for (std::size_t row = rows; row-- > 0;) {
        glm::dvec3 sum(0.0);
        for (std::size_t column = 0; column <= columns; ++column) {
            for (int c = 0; c < 3; ++c) sums.texels.push_back(static_cast<float>(sum[c] / image.width));
            sums.texels.push_back(1.0f);
            if (column < columns) sum += texel(image, row * columns + column);
        }
        if (!std::isfinite(sum.x + sum.y + sum.z) || std::abs(sum.x) + std::abs(sum.y) + std::abs(sum.z) > 1e6)
            throw Error(file.string(), "is no ramp: it has values that are not finite, or far from those of colours");
    }
    return sums;
}

RampSums read_ramp(const std::filesystem::path& file) {
    const assets::Image image = assets::read_image(file);
    if (image.width > max_ramp_columns || image.height > max_ramp_rows)
        throw Error(file.string(), fmt::format("is too large for a ramp: {}x{}, at most {}x{}", image.width,
                                               image.height, max_ramp_columns, max_ramp_rows));
    return sum_ramp(image, file);
}

const gpu::Texture& ToonRamps::texture(const std::string& file) {
    const auto found = textures_.find(file);
    if (found != textures_.end()) return found->second;
    const RampSums sums = read_ramp(file);
    gpu::Texture texture({sums.columns + 1, sums.rows, gpu::Format::rgba32f}, "toon ramp");
    texture.upload(std::span<const float>(sums.texels), gpu::RowOrder::bottom_first);
    texture.set_sampling(gpu::Sampling::nearest());
    return textures_.emplace(file, std::move(texture)).first->second;
}

} // namespace hachure
