#pragma once

#include <cstdint>

namespace hachure {

class App;

/// What the last frame deformed. A resource.
struct DeformCounts {
    std::uint64_t surfaces = 0;
    std::uint64_t vertices = 0;
    std::uint64_t on_gpu = 0; ///< of the surfaces: those whose vertices were left to the GPU
};

/// Skinned and morphing surfaces (Skin, MorphWeights) get the shape that their joints and weights give them: a Deformed
/// each. Only those whose joints, weights or settings (Deform) changed are deformed anew; the work is shared by all
/// threads.
///
/// Those whose Deform says so are deformed by the GPU instead, in pass "deform" of stage render, when they are seen. It
/// stays on the CPU what something there looks at: surfaces with EdgeLines, Metal or ShadeStrokes, with recomputed or
/// abstracted normals, and all of them while the AOV `velocity` is wanted or a brush has noise that motion carries along. So it
/// does without a Renderer, which is made before this is called.
void register_deform(App& app);

} // namespace hachure
