#include <hachure/runtime/gpu/gl.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/convolution_cost.h>
#include <hachure/systems/implicit_brush/stamp_convolver.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace hachure {
namespace {

constexpr int side = 192; // px

/// A small picture of stamps along a ring, as lines have them.
class SmallPicture {
public:
    explicit SmallPicture(RenderContext& render) : render_(render) {
        const gpu::TextureDesc desc{side, side, gpu::Format::rgba16f};
        job_ = {.places = make(desc),
                .inks = make(desc),
                .stamps = {0, 0, side, side},
                .radius = 8.0f,
                .largest_radius = 8.0f,
                .target = make(desc)};
        std::vector<float> places, inks;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const float away = std::hypot(static_cast<float>(x) - 96.0f, static_cast<float>(y) - 96.0f) - 60.0f;
                const float weight = std::abs(away) < 3.0f ? std::exp(-0.5f * away * away) : 0.0f;
                places.insert(places.end(), {0.0f, 0.0f, 8.0f, 0.0f});
                inks.insert(inks.end(), {0.0f, 0.0f, 0.0f, weight});
            }
        render.backend->texture(job_.places).upload(std::span<const float>(places));
        render.backend->texture(job_.inks).upload(std::span<const float>(inks));
    }
    ~SmallPicture() {
        for (const std::uint32_t id : made_) render_.backend->destroy_texture(id);
    }
    SmallPicture(const SmallPicture&) = delete;
    SmallPicture& operator=(const SmallPicture&) = delete;

    /// How many times as long a method takes as `cost` says.
    double factor(BrushMethod method, const ConvolutionCost& cost) {
        job_.method = method;
        std::vector<std::uint32_t> scratch;
        for (const gpu::TextureDesc& desc : job_.scratch(side, side)) scratch.push_back(make(desc));
        StampConvolver convolver;
        double least = std::numeric_limits<double>::max();
        for (int round = 0; round < 4; ++round) { // the first one compiles
            gpu::gl().Finish();
            const auto start = std::chrono::steady_clock::now();
            convolver.run(render_, job_, scratch);
            gpu::gl().Finish();
            const std::chrono::duration<double, std::nano> ns = std::chrono::steady_clock::now() - start;
            least = std::min(least, ns.count());
        }
        return least / cost.prices(job_, side, side).of(method, convolver.counts());
    }

private:
    std::uint32_t make(const gpu::TextureDesc& desc) {
        return made_.emplace_back(render_.backend->create_texture(desc, "convolution calibration"));
    }

    RenderContext& render_;
    ConvolveJob job_;
    std::vector<std::uint32_t> made_;
};

} // namespace

ConvolutionCost measured_cost(RenderContext& render) {
    ConvolutionCost cost;
    const ConvolutionCost given;
    SmallPicture picture(render);
    const double splat = picture.factor(BrushMethod::splat, given), gather = picture.factor(BrushMethod::gather, given);
    const double tiles = picture.factor(BrushMethod::tiles, given), sums = picture.factor(BrushMethod::sums, given);
    cost.splat_stamp *= splat;
    cost.splat_pixel *= splat;
    cost.sum_pixel *= splat;
    cost.gather_look *= gather;
    cost.gather_stamp *= gather;
    cost.marked_look *= tiles;
    cost.marked_stamp *= tiles;
    cost.running_sum *= sums;
    cost.edge *= sums;
    return cost;
}

ConvolutionCost context_cost(RenderContext& render) {
    return render.context->is_software() ? ConvolutionCost() : measured_cost(render);
}

} // namespace hachure
