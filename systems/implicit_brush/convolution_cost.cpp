#include <hachure/runtime/gpu/program.h>
#include <hachure/systems/implicit_brush/convolution_cost.h>
#include <hachure/systems/implicit_brush/convolution_plan.h>

#include <numbers>

namespace hachure {

void ConvolutionCost::set(gpu::Program& plan, const ConvolveJob& job, int picture_width, int picture_height) const {
    constexpr double tile_pixels = convolution_tile * convolution_tile;
    const double reach = job.reach(), rows = 2.0 * reach + 1.0;
    const double looked_at = std::numbers::pi * reach * reach;
    // Stamps near a tile lie in the square around it; a pixel adds those within the circle around itself.
    const double around = (convolution_tile + 2.0 * reach) * (convolution_tile + 2.0 * reach);
    const double additions = tile_pixels * looked_at / around;
    const double mark_looks = rows * (1.0 + 1.6 * reach / 32.0); // texels that a row's chord meets
    const auto set = [&](const char* name, double ns) { plan.set(name, static_cast<float>(ns)); };
    set("splat_stamp", splat_stamp);
    set("splat_pixel", splat_pixel * job.footprint.box_area(double(job.radius)));
    set("splat_tile", sum_pixel * tile_pixels);
    set("gather_tile", gather_look * tile_pixels * looked_at);
    set("gather_pair", gather_stamp * additions);
    set("marked_tile", marked_look * tile_pixels * mark_looks);
    set("marked_pair", marked_stamp * additions);
    const gpu::Rect area = job.painted(picture_width, picture_height);
    const double channels = job.sums_opacity() ? 1.0 : 4.0,
                 rim = 3.5 * std::numbers::pi * double(job.radius) + 2.0 * rows;
    set("sum_all", job.may_use(BrushMethod::sums) ? channels * running_sum * area.width * area.height : -1.0);
    set("sum_stamp", channels * edge * rim);
}

} // namespace hachure
