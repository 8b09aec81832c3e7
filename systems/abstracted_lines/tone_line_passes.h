#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/systems/abstracted_lines/line_finder.h>
#include <hachure/systems/abstracted_lines/tone_shading.h>

#include <vector>

namespace hachure {

/// Declares the passes of abstracted lines: `tone`, which draws the scene's tone; `tone_blur`; and `abstracted_lines`,
/// which finds lines in that and draws them onto `line_layer`; or, on request, the maps and points of its search.
class ToneLinePasses {
public:
    void declare(World& world);

private:
    /// Textures of one frame.
    struct Textures {
        gpu::TextureHandle tone;                ///< as drawn: red diffuse, green specular; blue, alpha: widths
        std::vector<gpu::TextureHandle> levels; ///< blurred
    };

    void declare_tone(World& world, Textures& textures);
    void declare_specular(World& world, const Textures& textures);
    void declare_blur(World& world, Textures& textures);
    void declare_lines(World& world, const Textures& textures);
    void declare_maps(World& world, const Textures& textures);
    void declare_points(World& world, const Textures& textures);

    ToneShading shading_;
    LineFinder finder_;
};

} // namespace hachure
