#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/image_luma.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/paper/grain.h>
#include <hachure/systems/paper/height_map.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace hachure {
namespace {

/// Orders as the float does.
std::uint32_t ordered_bits(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value + 0.0f); // + 0: there is one zero
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

/// What tells equal heights apart: odd factors, so that all differ.
std::uint32_t lot(std::uint32_t index) {
    std::uint32_t x = (index ^ (index >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

/// A sample of a row of texels that goes round, and how much each counts: a tent, wide enough to leave none out.
struct Tap {
    std::size_t first = 0;
    std::vector<float> weights;
};

std::vector<Tap> taps(int from, int to) {
    const double step = static_cast<double>(from) / to, reach = std::max(1.0, step);
    std::vector<Tap> result(static_cast<std::size_t>(to));
    for (int i = 0; i < to; ++i) {
        Tap& tap = result[static_cast<std::size_t>(i)];
        const double middle = (i + 0.5) * step - 0.5;
        const int first = static_cast<int>(std::ceil(middle - reach)),
                  last = static_cast<int>(std::floor(middle + reach));
        double sum = 0.0;
        for (int k = first; k <= last; ++k) sum += std::max(0.0, 1.0 - std::abs(k - middle) / reach);
        for (int k = first; k <= last; ++k)
            tap.weights.push_back(static_cast<float>(std::max(0.0, 1.0 - std::abs(k - middle) / reach) / sum));
        tap.first = static_cast<std::size_t>((first % from + from) % from);
    }
    return result;
}

/// Columns resampled and the result transposed, so that twice does both directions.
std::vector<float> resampled(const std::vector<float>& values, int columns, int to) {
    const std::vector<Tap> all = taps(columns, to);
    const auto width = static_cast<std::size_t>(columns), rows = values.size() / width;
    std::vector<float> result(all.size() * rows);
    for (std::size_t x = 0; x < all.size(); ++x)
        for (std::size_t y = 0; y < rows; ++y) {
            float sum = 0.0f;
            for (std::size_t k = 0; k < all[x].weights.size(); ++k)
                sum += all[x].weights[k] * values[y * width + (all[x].first + k) % width];
            result[x * rows + y] = sum;
        }
    return result;
}

} // namespace

HeightMap ranked_heights(int width, int height, const std::vector<float>& heights) {
    std::vector<std::uint64_t> order(heights.size()); // the height, then the texel
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = std::uint64_t{ordered_bits(heights[i])} << 32 | i;
    std::ranges::sort(order);
    // Ties by lot and not by place, which would make a slope of a plateau.
    for (std::size_t first = 0, end; first < order.size(); first = end) {
        for (end = first + 1; end < order.size() && order[end] >> 32 == order[first] >> 32;) ++end;
        std::ranges::sort(order.begin() + static_cast<std::ptrdiff_t>(first),
                          order.begin() + static_cast<std::ptrdiff_t>(end), {},
                          [](std::uint64_t entry) { return lot(static_cast<std::uint32_t>(entry)); });
    }
    HeightMap map{width, height, std::vector<std::uint8_t>(heights.size())};
    for (std::size_t rank = 0; rank < order.size(); ++rank)
        map.texels[order[rank] & 0xffffffffu] = static_cast<std::uint8_t>(rank * 256 / order.size());
    return map;
}

HeightMap picture_heights(const assets::Image& image, float scale, const std::filesystem::path& file) {
    const int width = std::max(1, static_cast<int>(std::lround(static_cast<float>(image.width) * scale)));
    const int height = std::max(1, static_cast<int>(std::lround(static_cast<float>(image.height) * scale)));
    if (std::max({width, height, image.width, image.height}) > max_paper_side)
        throw Error(file.string(),
                    fmt::format("is too large for paper: {}x{}, {}x{} pixels at this scale, at most {}x{}", image.width,
                                image.height, width, height, max_paper_side, max_paper_side));
    std::vector<float> heights(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    for (std::size_t i = 0; i < heights.size(); ++i) {
        heights[i] = assets::image_luma(image, i); // encoded: only the order of heights counts
        if (!std::isfinite(heights[i])) throw Error(file.string(), "is no paper: it has heights that are not finite");
    }
    const auto [low, high] = std::ranges::minmax(heights);
    if (!(low < high)) throw Error(file.string(), "is no paper: all its heights are the same");
    if (width != image.width || height != image.height)
        heights = resampled(resampled(heights, image.width, width), image.height, height);
    return ranked_heights(width, height, heights);
}

HeightMap make_sheet(const SheetKey& key) {
    if (!key.file.empty()) return picture_heights(assets::read_image(key.file), key.scale, key.file);
    return ranked_heights(grain_tile, grain_tile, paper_grain(key.kind, key.scale, key.seed));
}

} // namespace hachure
