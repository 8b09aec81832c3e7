#pragma once

#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/gl.h>
#include <hachure/runtime/gpu/shader_library.h>
#include <hachure/runtime/gpu/state.h>
#include <hachure/runtime/gpu/texture.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/runtime/scene/view_uniforms.h>
#include <hachure/systems/shade_strokes/shade_draw.h>
#include <hachure/tests/support/shade_rig.h>

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace hachure::test {

/// A view of what is around the origin, in perspective.
inline View shade_view(const glm::vec3& eye, int width, int height, float focal = 3.0f) {
    const float near_plane = 0.01f;
    View view;
    view.view_from_world = glm::lookAt(eye, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f));
    view.clip_from_view = glm::mat4(0.0f);
    view.clip_from_view[0][0] = focal * static_cast<float>(height) / static_cast<float>(width);
    view.clip_from_view[1][1] = focal;
    view.clip_from_view[2][3] = -1.0f;
    view.clip_from_view[3][2] = near_plane;
    view.clip_from_world = view.clip_from_view * view.view_from_world;
    view.eye = glm::vec4(eye, 1.0f);
    view.width = width;
    view.height = height;
    view.pixel_size = 2.0f / (focal * static_cast<float>(height));
    return view;
}

/// Draws the strokes of a ShadeRig by themselves, without a world. Needs a current context, which outlives it.
class ShadePicture {
public:
    explicit ShadePicture(const ShadeRig& rig)
        : chains(rig.chains()), size_(rig.mesh().size),
          triangles_(static_cast<std::uint32_t>(rig.shape().indices.size() / 3)),
          indices_(std::span<const std::uint32_t>(rig.shape().indices), "triangles"), vertex_array_("surface") {
        deform(rig.shape().positions);
        vertex_array_.set_attribute({.location = 0});
        vertex_array_.set_index_buffer(indices_);
    }

    /// Copies the strokes that the rig has now.
    void show(const ShadeRig& rig) {
        chains = rig.chains();
        buffers = ShadeBuffers();
    }

    void deform(const std::vector<glm::vec3>& places) {
        positions_ = gpu::Buffer(std::span<const glm::vec3>(places), "positions");
        vertex_array_.set_vertex_buffer(0, positions_, sizeof(glm::vec3));
    }

    /// What share of their amplitude strokes keep from now on, per vertex; or none for all of it.
    void narrow(std::vector<float> now) {
        shares_ = std::move(now);
        ++shares_version_;
    }

    /// The coverage of each pixel, rows from the bottom.
    std::vector<float> draw(const View& view) {
        if (!coverage_ || coverage_.width() != view.width || coverage_.height() != view.height) make_targets(view);
        gpu::gl().ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); // as Renderer has it
        view_uniforms_.bind(view, LightList{});
        buffers.update(chains, shares_, shares_version_);
        draw_depth();
        const ShadeStrokeDraw strokes = stroke_draw();
        strokes.find();
        coverage_.bind();
        gpu::apply({.viewport = {0, 0, view.width, view.height}, .blend = gpu::Blend::premultiplied});
        coverage_.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
        coverage_.clear_color(1, std::array{0.0f, 0.0f, 0.0f, 0.0f});
        strokes.draw(depth_, true);
        return coverage_texture_.read_floats(gpu::RowOrder::bottom_first);
    }

    [[nodiscard]] ShadeStrokeDraw stroke_draw() {
        return {.shaders = &shaders,
                .patterns = &patterns,
                .buffers = &buffers,
                .positions = &positions_,
                .indices = &indices_,
                .triangles = triangles_,
                .world_from_mesh = world_from_mesh,
                .size = size_,
                .style = style,
                .samples = samples_,
                .tick = tick};
    }

    ShadeChains chains; ///< a copy of the rig's
    ShadeStrokes style;
    std::uint32_t tick = 0;
    glm::mat4 world_from_mesh{1.0f};
    gpu::ShaderLibrary shaders;
    StrokePatterns patterns;
    ShadeBuffers buffers;

private:
    void make_targets(const View& view) {
        layer_ = gpu::Texture({view.width, view.height, gpu::Format::rgba16f}, "layer");
        coverage_texture_ = gpu::Texture({view.width, view.height, gpu::Format::r16f}, "coverage");
        samples_ = fine_samples(view.width, view.height);
        depth_ = gpu::Texture({samples_ * view.width, samples_ * view.height, gpu::Format::depth32f}, "depth");
        coverage_ = gpu::Framebuffer({&layer_, &coverage_texture_}, nullptr, "strokes");
        surface_ = gpu::Framebuffer({}, &depth_, "surface");
    }

    void draw_depth() {
        surface_.bind();
        gpu::apply({.viewport = {0, 0, depth_.desc().width, depth_.desc().height},
                    .depth_test = gpu::DepthTest::greater,
                    .depth_write = true,
                    .cull = gpu::Cull::back});
        surface_.clear_depth(0.0f);
        gpu::Program& program =
            shaders.program({.vertex = "surface/position.vert", .fragment = "surface/constant.frag"});
        program.set("world_from_entity", world_from_mesh);
        program.use();
        vertex_array_.bind();
        gpu::gl().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * triangles_), GL_UNSIGNED_INT, nullptr);
    }

    std::vector<float> shares_;
    std::uint64_t shares_version_ = 0;
    float size_;
    std::uint32_t triangles_;
    int samples_ = 1;
    gpu::Buffer positions_, indices_;
    gpu::VertexArray vertex_array_;
    ViewUniforms view_uniforms_;
    gpu::Texture layer_, coverage_texture_, depth_;
    gpu::Framebuffer coverage_, surface_;
};

} // namespace hachure::test
