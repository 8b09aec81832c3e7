#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/debug_messages.h>
#include <hachure/runtime/gpu/sampler.h>

#include <algorithm>

namespace hachure::gpu {
namespace {

GLint min_filter(const Sampling& sampling) {
    if (!sampling.mipmaps) return sampling.min == Filter::linear ? GL_LINEAR : GL_NEAREST;
    return sampling.min == Filter::linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST;
}

GLint wrap_mode(Wrap wrap) {
    switch (wrap) {
    case Wrap::clamp_to_edge:
        break;
    case Wrap::repeat:
        return GL_REPEAT;
    case Wrap::mirrored_repeat:
        return GL_MIRRORED_REPEAT;
    }
    return GL_CLAMP_TO_EDGE;
}

} // namespace

void detail::apply_sampling(const Sampling& sampling, GLuint object, PFNGLSAMPLERPARAMETERIPROC set_int,
                            PFNGLSAMPLERPARAMETERFPROC set_float) {
    set_int(object, GL_TEXTURE_MIN_FILTER, min_filter(sampling));
    set_int(object, GL_TEXTURE_MAG_FILTER, sampling.mag == Filter::linear ? GL_LINEAR : GL_NEAREST);
    set_int(object, GL_TEXTURE_WRAP_S, wrap_mode(sampling.wrap_u));
    set_int(object, GL_TEXTURE_WRAP_T, wrap_mode(sampling.wrap_v));
    set_int(object, GL_TEXTURE_COMPARE_MODE, sampling.compare ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
    set_int(object, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    const float limit = Context::current()->limits().max_anisotropy;
    constexpr GLenum max_anisotropy = 0x84FE; // core in 4.6; the extensions' value is the same
    if (limit > 1.0f) set_float(object, max_anisotropy, std::clamp(sampling.max_anisotropy, 1.0f, limit));
}

Sampler::Sampler(const Sampling& sampling, std::string_view label) {
    GLuint name = 0;
    gl().CreateSamplers(1, &name);
    handle_ = detail::Handle<&Sampler::destroy>(name);
    label_object(GL_SAMPLER, name, label);
    detail::apply_sampling(sampling, name, gl().SamplerParameteri, gl().SamplerParameterf);
}

void Sampler::destroy(GLuint name) { gl().DeleteSamplers(1, &name); }

void Sampler::bind(GLuint unit) const { gl().BindSampler(unit, name()); }

void Sampler::unbind(GLuint unit) { gl().BindSampler(unit, 0); }

} // namespace hachure::gpu
