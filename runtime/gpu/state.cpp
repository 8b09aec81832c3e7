#include <hachure/runtime/assert.h>
#include <hachure/runtime/gpu/state.h>

namespace hachure::gpu {
namespace {

void enable(GLenum capability, bool on) {
    if (on) {
        gl().Enable(capability);
    } else {
        gl().Disable(capability);
    }
}

GLboolean flag(bool on) { return on ? GL_TRUE : GL_FALSE; }

GLenum depth_function(DepthTest test) {
    switch (test) {
    case DepthTest::off:
    case DepthTest::less:
        break;
    case DepthTest::less_equal:
        return GL_LEQUAL;
    case DepthTest::equal:
        return GL_EQUAL;
    case DepthTest::greater:
        return GL_GREATER;
    case DepthTest::always:
        return GL_ALWAYS;
    }
    return GL_LESS;
}

void apply_area(const DrawState& state) {
    const Rect& view = state.viewport;
    HACHURE_ASSERT(view.width >= 0 && view.height >= 0, "a viewport has no negative size");
    gl().Viewport(view.x, view.y, view.width, view.height);
    const Rect scissor = state.scissor.value_or(view);
    HACHURE_ASSERT(scissor.width >= 0 && scissor.height >= 0, "a scissor has no negative size");
    gl().Scissor(scissor.x, scissor.y, scissor.width, scissor.height);
    enable(GL_SCISSOR_TEST, state.scissor.has_value());
}

void apply_depth(const DrawState& state) {
    HACHURE_ASSERT(!state.depth_write || state.depth_test != DepthTest::off,
                   "depth is written only where it is tested");
    enable(GL_DEPTH_TEST, state.depth_test != DepthTest::off);
    gl().DepthFunc(depth_function(state.depth_test));
    gl().DepthMask(flag(state.depth_write));
    gl().DepthRange(0.0, 1.0);
    enable(GL_DEPTH_CLAMP, false);
}

void apply_blend(const DrawState& state) {
    GLenum equation = GL_FUNC_ADD, source = GL_ONE, target = GL_ZERO, source_alpha = GL_ONE, target_alpha = GL_ZERO;
    switch (state.blend) {
    case Blend::off:
        break;
    case Blend::alpha:
        source = GL_SRC_ALPHA;
        target = target_alpha = GL_ONE_MINUS_SRC_ALPHA;
        break;
    case Blend::premultiplied:
        target = target_alpha = GL_ONE_MINUS_SRC_ALPHA;
        break;
    case Blend::add:
        target = target_alpha = GL_ONE;
        break;
    case Blend::multiply:
        source = source_alpha = GL_ZERO;
        target = GL_SRC_COLOR;
        target_alpha = GL_SRC_ALPHA;
        break;
    case Blend::min:
        equation = GL_MIN;
        break;
    case Blend::max:
        equation = GL_MAX;
        break;
    }
    enable(GL_BLEND, state.blend != Blend::off);
    gl().BlendEquation(equation);
    gl().BlendFuncSeparate(source, target, source_alpha, target_alpha);
    gl().ColorMask(flag(state.color_write[0]), flag(state.color_write[1]), flag(state.color_write[2]),
                   flag(state.color_write[3]));
}

void apply_raster(const DrawState& state) {
    enable(GL_CULL_FACE, state.cull != Cull::none);
    gl().CullFace(state.cull == Cull::front ? GL_FRONT : GL_BACK);
    gl().FrontFace(GL_CCW);
    const bool offset = state.polygon_offset_factor != 0.0f || state.polygon_offset_units != 0.0f;
    enable(GL_POLYGON_OFFSET_FILL, offset);
    gl().PolygonOffset(state.polygon_offset_factor, state.polygon_offset_units);
    gl().LineWidth(state.line_width);
    gl().PolygonMode(GL_FRONT_AND_BACK, state.wireframe ? GL_LINE : GL_FILL);
    enable(GL_PROGRAM_POINT_SIZE, state.program_point_size);
    enable(GL_PRIMITIVE_RESTART_FIXED_INDEX, false);
    enable(GL_RASTERIZER_DISCARD, false);
}

} // namespace

void apply(const DrawState& state) {
    apply_area(state);
    apply_depth(state);
    apply_blend(state);
    apply_raster(state);
    enable(GL_STENCIL_TEST, false);
    enable(GL_COLOR_LOGIC_OP, false);
    enable(GL_MULTISAMPLE, true);
    enable(GL_FRAMEBUFFER_SRGB, state.srgb_write);
}

} // namespace hachure::gpu
