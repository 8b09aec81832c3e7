#include <hachure/runtime/gpu/program.h>
#include <hachure/systems/implicit_brush/convolution_cost.h>
#include <hachure/systems/implicit_brush/convolution_plan.h>

#include <limits>
#include <numbers>

namespace hachure {

ConvolutionPrices ConvolutionCost::prices(const ConvolveJob& job, int picture_width, int picture_height) const {
    constexpr double tile = convolution_tile, block = gather_block, tile_pixels = tile * tile;
    const double reach = job.reach(), circle = std::numbers::pi * reach * reach;
    // Stamps near a tile lie in the square around it. Of those a pixel looks at the ones within a circle around itself,
    // or around its block.
    const double near_tile = (tile + 2.0 * reach) * (tile + 2.0 * reach);
    const double near_block = block * block + 4.0 * block * reach + circle;
    const double rows = block + 2.0 * reach, texels = 1.0 + (block + 1.6 * reach) / 32.0; // of marks, in a row
    const gpu::Rect area = job.painted(picture_width, picture_height);
    const double channels = job.sums_opacity() ? 1.0 : 4.0, radius = double(job.radius);
    const double rim = (3.5 * std::numbers::pi + 4.0) * radius; // pixels where a disk changes along rows
    const double sums = channels * running_sum * area.width * area.height;
    return {.splat_stamp = splat_stamp + splat_pixel * job.footprint.box_area(radius),
            .splat_tile = sum_pixel * tile_pixels,
            .gather_tile = gather_look * tile_pixels * circle,
            .gather_pair = gather_stamp * tile_pixels * circle / near_tile,
            .marked_tile = marked_look * tile_pixels * rows * texels,
            .marked_pair = marked_stamp * tile_pixels * near_block / near_tile,
            .sum_all = job.may_use(BrushMethod::sums) ? sums : -1.0,
            .sum_stamp = channels * edge * rim,
            .sum_tile = sum_pixel * tile_pixels};
}

double ConvolutionPrices::of(BrushMethod method, const ConvolutionCounts& counts) const {
    const double stamps = counts.stamps, tiles = counts.tiles, pairs = counts.pairs;
    switch (method) {
    case BrushMethod::splat:
        return stamps * splat_stamp + tiles * splat_tile;
    case BrushMethod::gather:
        return tiles * gather_tile + pairs * gather_pair;
    case BrushMethod::tiles:
        return tiles * marked_tile + pairs * marked_pair;
    case BrushMethod::sums:
        return sum_all < 0.0 ? std::numeric_limits<double>::infinity()
                             : sum_all + stamps * sum_stamp + tiles * sum_tile;
    case BrushMethod::automatic:
        break;
    }
    return 0.0;
}

void ConvolutionPrices::set(gpu::Program& plan) const {
    const auto set = [&](const char* name, double ns) { plan.set(name, static_cast<float>(ns)); };
    set("splat_stamp", splat_stamp);
    set("splat_tile", splat_tile);
    set("gather_tile", gather_tile);
    set("gather_pair", gather_pair);
    set("marked_tile", marked_tile);
    set("marked_pair", marked_pair);
    set("sum_all", sum_all);
    set("sum_stamp", sum_stamp);
    set("sum_tile", sum_tile);
}

} // namespace hachure
