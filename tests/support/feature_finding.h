#pragma once

#include <hachure/runtime/gpu/gl.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/feature_data.h>
#include <hachure/systems/implicit_brush/feature_profile.h>
#include <hachure/systems/implicit_brush/slope_diffusion.h>
#include <hachure/systems/implicit_brush/slope_job.h>
#include <hachure/tests/support/line_images.h>

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::test {

/// What the shaders know of a feature at a pixel.
struct PixelProfile {
    glm::dvec2 offset{1e4}; ///< from the pixel's centre to the line, px
    double height = 0.0, curvature = 0.0;
    [[nodiscard]] bool found() const { return height > 0.0; }
};

struct PixelFeature {
    double height = 0.0;
    glm::dvec2 twice_angle{0.0};
    double singularity = 0.0;
};

/// A slope and how it is insulated, in rows from the bottom.
struct SlopeImage {
    int width = 0, height = 0;
    std::vector<float> texels; ///< 4 each, as SlopeJob makes them

    SlopeImage(int w, int h) : width(w), height(h), texels(std::size_t(4) * std::size_t(w) * std::size_t(h)) {}

    float* at(int x, int y) {
        return &texels[4 *
                       (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
    }
    /// The slope of a relief, given as its gradient at a place.
    template <class Gradient> static SlopeImage of(int width, int height, const Gradient& gradient) {
        SlopeImage image(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const glm::dvec2 g = gradient(pixel_center(x, y));
                float* s = image.at(x, y);
                s[0] = static_cast<float>(g.x), s[1] = static_cast<float>(g.y), s[2] = 0.0f, s[3] = 1.0f;
            }
        return image;
    }
};

/// How features are found.
struct FeatureSettings {
    BrushFeature feature = BrushFeature::ridges;
    int diffusion = 0, steps_at_once = 1;
    float window = 6.0f;
    int taps = 4, fits = 2;
    float most_singular = FeatureProfileJob{}.most_singular;
    float least_height = 0.0f, reach = 1e4f;
    gpu::Format storage = gpu::Format::rgba32f;
};

/// Finds features in given slopes or tones with the shaders of implicit brushes, without a scene.
class FeatureFinding {
public:
    FeatureFinding(RenderContext& render, const FeatureSettings& settings, int width, int height)
        : render_(render), settings_(settings), width_(width), height_(height), rect_{0, 0, width, height} {
        for (std::uint32_t* id : {&slopes_, &diffused_, &scratch_, &scratch_2_, &data_, &profile_})
            *id = make(settings.storage);
        gpu::gl().ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); // as the renderer has it: depths of marks
        tones_ = make(gpu::Format::rg32f);
        candidates_ = make(gpu::Format::depth32f);
    }
    ~FeatureFinding() {
        for (const std::uint32_t id : made_) render_.backend->destroy_texture(id);
    }
    FeatureFinding(const FeatureFinding&) = delete;
    FeatureFinding& operator=(const FeatureFinding&) = delete;

    /// Confines all steps; everything, unless it is called.
    void confine(const gpu::Rect& rect) { rect_ = rect; }

    void find(const SlopeImage& slopes) {
        upload(slopes);
        run();
    }

    /// In the relief of tones.
    void find(const Tones& tones) {
        upload(tones);
        luminance_ = true;
        slope_of_tones();
        run();
    }

    /// The steps on their own.
    void upload(const SlopeImage& slopes) {
        luminance_ = false;
        render_.backend->texture(slopes_).upload(std::span<const float>(slopes.texels), gpu::RowOrder::bottom_first);
    }
    void upload(const Tones& tones) {
        std::vector<float> texels;
        for (const double t : tones.values) texels.insert(texels.end(), {static_cast<float>(t), 1.0f});
        render_.backend->texture(tones_).upload(std::span<const float>(texels), gpu::RowOrder::bottom_first);
    }
    void slope_of_tones() {
        SlopeJob{.kind = SlopeKind::luminance, .tones = tones_, .rect = rect_, .to = slopes_}.run(render_);
    }
    void diffuse() {
        if (settings_.diffusion > 0)
            SlopeDiffusionJob{settings_.diffusion, settings_.steps_at_once, slopes_, diffused_, scratch_, rect_}.run(
                render_);
    }
    void extract() {
        FeatureDataJob{.feature = settings_.feature,
                       .luminance = luminance_,
                       .window = {settings_.window},
                       .slopes = settings_.diffusion > 0 ? diffused_ : slopes_,
                       .scratch = scratch_,
                       .scratch_2 = scratch_2_,
                       .to = data_,
                       .rect = rect_}
            .run(render_);
    }
    void profile() {
        FeatureProfileJob{.taps = settings_.taps,
                          .fits = settings_.fits,
                          .most_singular = settings_.most_singular,
                          .window = {settings_.window},
                          .least_height = settings_.least_height,
                          .reach = settings_.reach,
                          .data = data_,
                          .candidates = candidates_,
                          .to = profile_,
                          .valid = rect_,
                          .rect = rect_}
            .run(render_);
    }
    void run() { diffuse(), extract(), profile(); }

    [[nodiscard]] std::vector<PixelProfile> profiles() const {
        const std::vector<float> t = floats(profile_);
        std::vector<PixelProfile> all(t.size() / 4);
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = {{t[4 * i], t[4 * i + 1]}, t[4 * i + 2], t[4 * i + 3]};
        return all;
    }
    [[nodiscard]] std::vector<PixelFeature> features() const {
        const std::vector<float> t = floats(data_);
        std::vector<PixelFeature> all(t.size() / 4);
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = {t[4 * i], {t[4 * i + 1], t[4 * i + 2]}, t[4 * i + 3]};
        return all;
    }
    [[nodiscard]] std::vector<float> slopes() const { return floats(settings_.diffusion > 0 ? diffused_ : slopes_); }

    [[nodiscard]] bool all_finite() const {
        for (const std::uint32_t id : {slopes_, data_, profile_})
            if (!std::ranges::all_of(floats(id), [](float v) { return std::isfinite(v); })) return false;
        return true;
    }
    /// To have other jobs work in.
    [[nodiscard]] std::uint32_t slope_texture() const { return slopes_; }

private:
    [[nodiscard]] std::vector<float> floats(std::uint32_t id) const {
        return render_.backend->texture(id).read_floats(gpu::RowOrder::bottom_first);
    }
    std::uint32_t make(gpu::Format format) {
        return made_.emplace_back(render_.backend->create_texture({width_, height_, format}, "feature"));
    }

    RenderContext& render_;
    FeatureSettings settings_;
    int width_, height_;
    gpu::Rect rect_;
    bool luminance_ = false;
    std::uint32_t slopes_ = 0, diffused_ = 0, scratch_ = 0, scratch_2_ = 0, data_ = 0, profile_ = 0;
    std::uint32_t tones_ = 0, candidates_ = 0;
    std::vector<std::uint32_t> made_;
};

} // namespace hachure::test
