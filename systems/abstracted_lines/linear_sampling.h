#pragma once

#include <hachure/runtime/gpu/sampler.h>
#include <hachure/runtime/scene/render_context.h>

#include <cstdint>

namespace hachure {

/// A texture of the frame graph is read between its texels while this lives; the graph's own way is the nearest texel.
class LinearSampling {
public:
    LinearSampling(RenderContext& render, std::uint32_t id) : texture_(render.backend->texture(id)) {
        texture_.set_sampling(gpu::Sampling());
    }
    ~LinearSampling() { texture_.set_sampling(gpu::Sampling::nearest()); }
    LinearSampling(const LinearSampling&) = delete;
    LinearSampling& operator=(const LinearSampling&) = delete;

private:
    gpu::Texture& texture_;
};

} // namespace hachure
