#pragma once

#include <hachure/components/abstracted_lines.h>
#include <hachure/components/tone_image.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/abstracted_lines/line_finder.h>
#include <hachure/systems/abstracted_lines/tone_blur.h>
#include <hachure/systems/abstracted_lines/tone_levels.h>
#include <hachure/systems/abstracted_lines/tone_line_frame.h>
#include <hachure/systems/abstracted_lines/tone_quality.h>
#include <hachure/tests/support/line_images.h>

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::test {

/// What the shaders find at a pixel, in one channel of the tone image.
struct PixelLine {
    glm::dvec2 offset{0.0}; ///< from the pixel's centre to the line, pixels
    double curvature = 0.0; ///< signed; 0 where there is no line
    double strength = 0.0;  ///< opacity along the line
    double dark = 0.0;      ///< opacity of dark lines of both channels
    double highlight = 0.0; ///< of highlight lines
};

/// Finds lines in given tones with the shaders of abstracted lines, without a scene.
class LineFinding {
public:
    /// Pictures of `width` x `height`.
    LineFinding(RenderContext& render, const AbstractedLines& lines, const ToneImage& quality, int width, int height)
        : render_(render), quality_(resolved(quality)), style_(line_style(lines, View{})),
          least_curvature_(least_curvature(lines)),
          searched_(std::max(full_width(lines, View{}), narrowest_search)), desc_{
                                                                                width, height,
                                                                                tone_format(quality_.storage, false)} {
        source_ = make(desc_, "source");
        blurred_ = make(desc_, "blurred");
        for (const gpu::TextureDesc& desc : ToneBlurJob::scratch(quality_.blur, sigma(), desc_))
            scratch_.push_back(make(desc, "scratch"));
        for (std::uint32_t& map : maps_) map = make({width, height, gpu::Format::rg32f}, "map");
        for (const std::size_t i : {0u, 2u}) points_[i] = make({width, height, gpu::Format::rgba32f}, "points");
        for (const std::size_t i : {1u, 3u}) points_[i] = make({width, height, gpu::Format::rgba16f}, "directions");
        points_[4] = make({width, height, gpu::Format::r32ui}, "owner");
        layer_ = make({width, height, gpu::Format::rgba16f}, "layer");
        candidates_ = make({width, height, gpu::Format::depth32f}, "candidates");
        for (std::uint32_t& found : found_) found = make(LineFinder::found_desc(width, height), "found");
        rects_ = {whole(), whole(), whole()};
    }

    /// Confines the steps to where lines can be; everything, unless it is called.
    void confine(const ToneRects& rects) { rects_ = rects; }

    ~LineFinding() {
        for (const std::uint32_t id : made_) render_.backend->destroy_texture(id);
    }
    LineFinding(const LineFinding&) = delete;
    LineFinding& operator=(const LineFinding&) = delete;

    [[nodiscard]] double searched_width() const { return static_cast<double>(searched_); }

    /// The lines of the diffuse channel; the specular one is `specular`, or empty.
    std::vector<PixelLine> find(const Tones& diffuse, const Tones* specular = nullptr) {
        upload(diffuse, specular);
        blur();
        search(LineOutput::maps);
        search(LineOutput::points);
        return read();
    }

    /// The steps on their own, for measuring: tones to the GPU, blur, search.
    void upload(const Tones& diffuse, const Tones* specular = nullptr) {
        std::vector<float> pixels;
        pixels.reserve(2 * diffuse.values.size());
        for (std::size_t i = 0; i < diffuse.values.size(); ++i) {
            pixels.push_back(static_cast<float>(diffuse.values[i]));
            pixels.push_back(specular ? static_cast<float>(specular->values[i]) : 0.0f);
        }
        render_.backend->texture(source_).upload(std::span<const float>(pixels), gpu::RowOrder::bottom_first);
    }

    void blur() {
        ToneBlurJob{.kind = quality_.blur,
                    .sigma = sigma(),
                    .from = source_,
                    .to = blurred_,
                    .valid = rects_.shaded,
                    .rect = rects_.blurred}
            .run(render_, scratch_);
    }

    void search(LineOutput output) {
        const gpu::Framebuffer& target = cleared(output);
        const ToneLevel level{blurred_, static_cast<double>(searched_)};
        finder_.run(render_, {.quality = quality_,
                              .levels = std::span(&level, 1),
                              .styles = std::span(&style_, 1),
                              .width = searched_,
                              .least_curvature = least_curvature_,
                              .rect = rects_.lines,
                              .output = output,
                              .target = &target,
                              .found = found_,
                              .candidates = output == LineOutput::layer ? candidates_ : 0});
    }

    [[nodiscard]] std::vector<PixelLine> read(bool specular = false) const {
        const auto floats = [&](std::uint32_t id) {
            return render_.backend->texture(id).read_floats(gpu::RowOrder::bottom_first);
        };
        const std::vector<float> points = floats(points_[specular ? 2 : 0]), opacity = floats(maps_[2]);
        std::vector<PixelLine> lines(opacity.size() / 2);
        for (std::size_t i = 0; i < lines.size(); ++i)
            lines[i] = {{points[4 * i], points[4 * i + 1]},
                        points[4 * i + 2],
                        points[4 * i + 3],
                        opacity[2 * i],
                        opacity[2 * i + 1]};
        return lines;
    }

    /// Everything that the shaders wrote, to look for what is no number.
    [[nodiscard]] bool all_finite() const {
        bool finite = true;
        for (const std::uint32_t id : {maps_[0], maps_[1], maps_[2], points_[0], points_[1], points_[2], points_[3]})
            for (const float v : render_.backend->texture(id).read_floats()) finite &= std::isfinite(v);
        return finite;
    }

private:
    const gpu::Framebuffer& cleared(LineOutput output) {
        const auto& p = points_;
        const gpu::Framebuffer& target =
            output == LineOutput::layer  ? render_.backend->framebuffer({layer_}, candidates_)
            : output == LineOutput::maps ? render_.backend->framebuffer({maps_[0], maps_[1], maps_[2]})
                                         : render_.backend->framebuffer({p[0], p[1], p[2], p[3], p[4]});
        target.bind();
        gpu::apply({.viewport = whole(), .scissor = rects_.lines});
        const int floats = output == LineOutput::layer ? 1 : output == LineOutput::maps ? 3 : 4;
        for (int i = 0; i < floats; ++i) target.clear_color(i, std::array{0.0f, 0.0f, 0.0f, 0.0f});
        if (output == LineOutput::points) target.clear_color(4, std::array{0u, 0u, 0u, 0u});
        return target;
    }

    std::uint32_t make(const gpu::TextureDesc& desc, const char* label) {
        return made_.emplace_back(render_.backend->create_texture(desc, label));
    }
    [[nodiscard]] double sigma() const { return blur_sigma(static_cast<double>(searched_)); }
    [[nodiscard]] gpu::Rect whole() const { return {0, 0, desc_.width, desc_.height}; }

    RenderContext& render_;
    ToneImage quality_;
    ToneLineStyle style_;
    float least_curvature_;
    float searched_; ///< width
    gpu::TextureDesc desc_;
    std::uint32_t source_ = 0, blurred_ = 0;
    std::vector<std::uint32_t> scratch_, made_;
    std::array<std::uint32_t, 3> maps_{};
    std::array<std::uint32_t, 5> points_{};
    std::uint32_t layer_ = 0, candidates_ = 0;
    std::array<std::uint32_t, 2> found_{};
    ToneRects rects_;
    LineFinder finder_;
};

/// Lines whose opacity says nothing but whether a pixel belongs to them: sharp rims, opaque from half the curvature
/// that a bar of this contrast has.
inline AbstractedLines plain_lines(double width, double contrast) {
    AbstractedLines lines;
    lines.width = static_cast<float>(width);
    lines.fade = 0.0f;
    lines.counterchange = 0.0f;
    lines.dark_low = lines.highlight_low = static_cast<float>(0.02 * contrast);
    lines.dark_high = lines.highlight_high = static_cast<float>(0.04 * contrast);
    return lines;
}

} // namespace hachure::test
