#pragma once

#include <hachure/runtime/gpu/texture.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/stamp_convolver.h>
#include <hachure/tests/support/stamp_images.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::test {

/// Stamps on the GPU, and the ink that a convolver makes of them.
class ConvolutionRun {
public:
    ConvolutionRun(RenderContext& render, int width, int height, gpu::Format format = gpu::Format::rgba16f)
        : render_(render), width_(width), height_(height) {
        job.places = make({width, height, format}, "places");
        job.inks = make({width, height, format}, "inks");
        job.target = make({width, height, gpu::Format::rgba32f}, "target");
        job.stamps = {0, 0, width, height};
    }
    ~ConvolutionRun() {
        forget_scratch();
        for (const std::uint32_t id : made_) render_.backend->destroy_texture(id);
    }
    ConvolutionRun(const ConvolutionRun&) = delete;
    ConvolutionRun& operator=(const ConvolutionRun&) = delete;

    /// Stores stamps; returns them as the textures hold them.
    StampImage upload(const StampImage& image) {
        std::vector<float> places, inks;
        for (const StampImage::Stamp& s : image.stamps) {
            places.insert(places.end(), {s.x, s.y, s.radius, s.angle});
            inks.insert(inks.end(), {s.red, s.green, s.blue, s.weight});
        }
        texture(job.places).upload(std::span<const float>(places), gpu::RowOrder::bottom_first);
        texture(job.inks).upload(std::span<const float>(inks), gpu::RowOrder::bottom_first);
        places = texture(job.places).read_floats(gpu::RowOrder::bottom_first);
        inks = texture(job.inks).read_floats(gpu::RowOrder::bottom_first);
        StampImage stored(image.width, image.height);
        for (std::size_t i = 0; i < stored.stamps.size(); ++i)
            stored.stamps[i] = {places[4 * i], places[4 * i + 1], places[4 * i + 2], places[4 * i + 3],
                                inks[4 * i],   inks[4 * i + 1],   inks[4 * i + 2],   inks[4 * i + 3]};
        return stored;
    }

    /// Paints over `background`.
    void run(const std::array<float, 4>& background = {}) {
        texture(job.target).clear(background);
        paint();
    }

    void paint() {
        const std::vector<gpu::TextureDesc> wanted = job.scratch(width_, height_);
        if (wanted != descs_) {
            forget_scratch();
            for (const gpu::TextureDesc& desc : wanted)
                scratch_.push_back(render_.backend->create_texture(desc, "scratch"));
            descs_ = wanted;
        }
        convolver.run(render_, job, scratch_);
    }

    /// 4 values a pixel, the bottom row first.
    [[nodiscard]] std::vector<float> read() { return texture(job.target).read_floats(gpu::RowOrder::bottom_first); }

    [[nodiscard]] std::vector<float> ink(const StampImage& image) {
        upload(image);
        run();
        return read();
    }

    ConvolveJob job;
    StampConvolver convolver;

private:
    gpu::Texture& texture(std::uint32_t id) { return render_.backend->texture(id); }
    std::uint32_t make(const gpu::TextureDesc& desc, const char* label) {
        return made_.emplace_back(render_.backend->create_texture(desc, label));
    }
    void forget_scratch() {
        for (const std::uint32_t id : scratch_) render_.backend->destroy_texture(id);
        scratch_.clear();
    }

    RenderContext& render_;
    int width_, height_;
    std::vector<std::uint32_t> made_, scratch_;
    std::vector<gpu::TextureDesc> descs_;
};

} // namespace hachure::test
