#include <hachure/runtime/gpu/program.h>
#include <hachure/systems/implicit_brush/convolution_cost.h>
#include <hachure/systems/implicit_brush/convolution_plan.h>

#include <numbers>

namespace hachure {

void ConvolutionCost::set(gpu::Program& plan, const ConvolveJob& job, int picture_width, int picture_height) const {
    constexpr double tile = convolution_tile, block = gather_block, tile_pixels = tile * tile;
    const double reach = job.reach(), circle = std::numbers::pi * reach * reach;
    // Stamps near a tile lie in the square around it. Of those a pixel looks at the ones within a circle around itself,
    // or around its block.
    const double near_tile = (tile + 2.0 * reach) * (tile + 2.0 * reach);
    const double near_block = block * block + 4.0 * block * reach + circle;
    const double rows = block + 2.0 * reach, texels = 1.0 + (block + 1.6 * reach) / 32.0; // of marks, in a row
    const gpu::Rect area = job.painted(picture_width, picture_height);
    const double channels = job.sums_opacity() ? 1.0 : 4.0, radius = double(job.radius);
    const double rim = 3.5 * std::numbers::pi * radius + 4.0 * radius; // pixels where a disk changes along rows
    const auto set = [&](const char* name, double ns) { plan.set(name, static_cast<float>(ns)); };
    set("splat_stamp", splat_stamp);
    set("splat_pixel", splat_pixel * job.footprint.box_area(double(job.radius)));
    set("splat_tile", sum_pixel * tile_pixels);
    set("gather_tile", gather_look * tile_pixels * circle);
    set("gather_pair", gather_stamp * tile_pixels * circle / near_tile);
    set("marked_tile", marked_look * tile_pixels * rows * texels);
    set("marked_pair", marked_stamp * tile_pixels * near_block / near_tile);
    set("sum_all", job.may_use(BrushMethod::sums) ? channels * running_sum * area.width * area.height : -1.0);
    set("sum_stamp", channels * edge * rim);
}

} // namespace hachure
