#pragma once

#include <hachure/runtime/gpu/handle.h>

#include <cstdint>
#include <string_view>

namespace hachure::gpu {

enum class Filter : std::uint8_t { nearest, linear };
enum class Wrap : std::uint8_t { clamp_to_edge, repeat, mirrored_repeat };

/// How a shader reads a texture.
struct Sampling {
    Filter min = Filter::linear;
    Filter mag = Filter::linear;
    bool mipmaps = false; ///< choose among the levels, and blend them when `min` is linear
    Wrap wrap_u = Wrap::clamp_to_edge;
    Wrap wrap_v = Wrap::clamp_to_edge;
    float max_anisotropy = 1.0f; ///< >= 1; cut to what the driver allows
    bool compare = false;        ///< a depth texture read through sampler2DShadow, "less or equal"

    friend bool operator==(const Sampling&, const Sampling&) = default;

    [[nodiscard]] static constexpr Sampling nearest() { return {.min = Filter::nearest, .mag = Filter::nearest}; }
};

/// A sampler object: overrides how the texture of its unit is read (glCreateSamplers).
class Sampler {
public:
    Sampler() = default;
    explicit Sampler(const Sampling& sampling, std::string_view label);

    /// Applies to texture unit `unit` until another sampler, or unbind(), replaces it (glBindSampler).
    void bind(GLuint unit) const;
    static void unbind(GLuint unit);

    [[nodiscard]] GLuint name() const { return handle_.get(); }

private:
    static void destroy(GLuint name);
    detail::Handle<&Sampler::destroy> handle_;
};

namespace detail {
/// Sets a sampler's or a texture's parameters: the two differ in the entries that take them, not in their names.
void apply_sampling(const Sampling& sampling, GLuint object, PFNGLSAMPLERPARAMETERIPROC set_int,
                    PFNGLSAMPLERPARAMETERFPROC set_float);
} // namespace detail

} // namespace hachure::gpu
