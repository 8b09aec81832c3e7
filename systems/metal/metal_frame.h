#pragma once

#include <hachure/components/metal.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/systems/metal/metal_surfaces.h>
#include <hachure/systems/metal/stripe_ramp.h>

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace hachure {

/// A StripeRamp as shaders/metal/ramp.glsl reads it.
struct RampBuffer {
    gpu::Buffer buffer;
    int knot_count = 0;
    float mean = 0.0f;
};

/// What metal keeps from frame to frame. A resource, of the thread of the render context.
class MetalFrame {
public:
    MetalSurfaces surfaces;

    /// A frame begins.
    void begin();

    /// The stripes of that set; they stay where they are until the next frame.
    [[nodiscard]] const RampBuffer& ramp(const StripeSet& set);

    /// Says that a layout is needed in this frame. Where the mesh lacks the texture coordinates that are asked for,
    /// a warning says so, once.
    void want_layout(std::uint64_t key, const SurfaceMesh& mesh, const Metal& metal);

    /// Makes those that are not there, on all threads.
    void lay_out_wanted();

    /// Whether there may be layouts and shapes that nothing in this frame is drawn with.
    [[nodiscard]] bool may_forget() const {
        return surfaces.layout_count() > wanted_.size() || surfaces.shape_count() > drawn_;
    }

private:
    struct Missing {
        std::uint64_t key;
        const SurfaceMesh* mesh;
        const Metal* metal;
    };

    std::unordered_map<std::uint64_t, RampBuffer> ramps_;
    std::unordered_set<std::uint64_t> wanted_;
    std::size_t drawn_ = 0; ///< surfaces that ask for a layout in this frame
    std::vector<Missing> missing_;
    std::unordered_set<std::string> warned_;
};

} // namespace hachure
