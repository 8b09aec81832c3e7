#pragma once

#include <hachure/runtime/gpu/frame_graph_backend.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/query.h>
#include <hachure/runtime/gpu/texture.h>

#include <cstdint>
#include <initializer_list>
#include <map>
#include <unordered_map>
#include <vector>

namespace hachure::gpu {

/// The frame graph's back end on OpenGL: ids are gpu::Textures, each pass is a debug group with a timer. Belongs to the
/// context that is current when it is made.
class GlFrameGraphBackend final : public FrameGraphBackend {
public:
    std::uint32_t create_texture(const TextureDesc& desc, std::string_view label) override;
    void destroy_texture(std::uint32_t id) override;
    std::uint64_t begin_pass(std::string_view name) override;
    void end_pass() override;
    std::optional<double> gpu_ms(std::uint64_t ticket) override;
    void finish() override;

    /// The texture of an id that `PassContext::texture` or `FrameGraph::texture` gave.
    [[nodiscard]] Texture& texture(std::uint32_t id);

    /// A framebuffer of these textures, made once per combination; an id of 0 leaves an output or the depth out.
    [[nodiscard]] const Framebuffer& framebuffer(std::initializer_list<std::uint32_t> colors, std::uint32_t depth = 0);

private:
    struct Timing {
        std::uint64_t ticket = 0;
        TimerQuery query;
    };

    std::unordered_map<std::uint32_t, Texture> textures_;
    std::map<std::vector<std::uint32_t>, Framebuffer> framebuffers_; ///< key: depth, then colours
    std::uint32_t next_id_ = 1;
    std::vector<TimerQuery> idle_queries_;
    std::vector<Timing> timings_; ///< the last one belongs to the pass that is open
    std::uint64_t next_ticket_ = 1;
};

} // namespace hachure::gpu
