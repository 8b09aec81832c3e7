#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/abstracted_lines/tone_line_frame.h>
#include <hachure/tests/support/line_images.h>
#include <hachure/tests/support/line_score.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace hachure::bench {

/// The tone image of a model in view, and where its lines can be: what the cost of finding lines is measured on.
struct SceneTones {
    test::Tones diffuse{1, 1}, specular{1, 1};
    ToneRects rects;
};

/// Bunny, or `model`; a torus where `quick`.
[[nodiscard]] SceneTones scene_tones(gpu::Context& context, const std::filesystem::path& model, bool quick);

/// What a whole frame costs more with lines than without, ms: the model in view, and beside it.
struct FrameCost {
    double in_view = 0.0, beside = 0.0;
};
[[nodiscard]] FrameCost frame_cost(gpu::Context& context, const std::filesystem::path& model, const ToneImage& quality,
                                   int frames, bool quick);

/// What the tone image itself costs, ms, at each of several numbers of samples: the least of `rounds`, taken in turns.
[[nodiscard]] std::vector<double> tone_costs(gpu::Context& context, const std::vector<int>& samples, int rounds,
                                             bool quick);

/// An AOV's first channel, rows from the bottom.
[[nodiscard]] test::Tones tones_of(const assets::Image& image);

/// One full-screen pass of nine fetches from RG16F: what costs are compared with.
class NineFetches {
public:
    NineFetches(int width, int height);
    void run() const;

private:
    gpu::Program program_;
    gpu::Texture from_, to_;
    gpu::Framebuffer framebuffer_;
    gpu::FullScreen full_screen_;
};

/// Blur and lines of both channels, with a quality.
struct Finding {
    const char* name;
    ToneImage quality;
    double width = 4.0;
    float beta = 0.2f;
};

struct Cost {
    double blur_ms = 0.0, lines_ms = 0.0, floor_ms = 0.0;
    [[nodiscard]] double ms() const { return blur_ms + lines_ms; }
};

/// Medians of `rounds`, in which the floor and both steps take turns.
[[nodiscard]] Cost cost_of(RenderContext& render, const Finding& finding, const SceneTones& tones, int rounds);

/// The least of `rounds`, in which all findings take turns, so that a slow spell of the machine strikes all of them.
[[nodiscard]] std::vector<Cost> costs_of(RenderContext& render, const std::vector<Finding>& findings,
                                         const SceneTones& tones, int rounds);

/// How accurate it is, on bars of several widths (or its own alone) at many angles.
struct Accuracy {
    double rms = 0.0;       ///< pixels
    double recall = 1.0;    ///< the least of all
    double precision = 1.0; ///< likewise
    double band = 0.0;      ///< the largest deviation from 1
};
[[nodiscard]] Accuracy accuracy_of(RenderContext& render, const Finding& finding, const std::vector<double>& widths,
                                   double contrast, int angles);

} // namespace hachure::bench
