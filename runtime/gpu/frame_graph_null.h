#pragma once

#include <hachure/runtime/gpu/frame_graph_backend.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hachure::gpu {

/// A back end without a GPU: it counts what the graph does and stores one number per texture, which passes of tests use
/// as the texture's contents. Wrong use (an unknown id, a nested pass) is an assertion.
class NullBackend final : public FrameGraphBackend {
public:
    std::uint32_t create_texture(const TextureDesc& desc, std::string_view label) override;
    void destroy_texture(std::uint32_t id) override;
    std::uint64_t begin_pass(std::string_view name) override;
    void end_pass() override;
    std::optional<double> gpu_ms(std::uint64_t ticket) override;
    void finish() override;

    /// What the texture "holds"; of any id, since imported textures have contents too. A new texture holds a number
    /// that no other one ever held.
    [[nodiscard]] std::uint64_t& contents(std::uint32_t id) { return contents_[id]; }

    /// The shape a living texture was created with; null for other ids, imported ones among them.
    [[nodiscard]] const TextureDesc* desc(std::uint32_t id) const;

    [[nodiscard]] std::size_t created() const { return created_; }
    [[nodiscard]] std::size_t destroyed() const { return destroyed_; }
    [[nodiscard]] std::size_t alive() const { return textures_.size(); }
    [[nodiscard]] std::size_t alive_bytes() const;

    /// Names of the passes begun since the last clear_passes(), in order.
    [[nodiscard]] std::span<const std::string> passes() const { return passes_; }
    void clear_passes() { passes_.clear(); }
    [[nodiscard]] bool in_pass() const { return in_pass_; }

    /// Makes create_texture() throw hachure::Error once it has made `count` more textures.
    void fail_creation_after(std::size_t count) { creations_left_ = count; }
    void allow_creation() { creations_left_ = std::numeric_limits<std::size_t>::max(); }

    /// The GPU time that every pass will report from now on; nothing: passes are not timed.
    void set_gpu_ms(std::optional<double> milliseconds) { pass_ms_ = milliseconds; }

    /// While delayed, times arrive only with finish().
    void delay_timers(bool delay) { delay_ = delay; }

    /// Tickets that have not been answered yet.
    [[nodiscard]] std::size_t pending_timers() const { return timers_.size(); }

private:
    struct Timer {
        double milliseconds = 0;
        bool ready = false;
    };

    std::map<std::uint32_t, TextureDesc> textures_;
    std::map<std::uint32_t, std::uint64_t> contents_;
    std::map<std::uint64_t, Timer> timers_;
    std::vector<std::string> passes_;
    std::optional<double> pass_ms_ = 0.0;
    std::size_t created_ = 0;
    std::size_t destroyed_ = 0;
    std::size_t creations_left_ = std::numeric_limits<std::size_t>::max();
    std::uint64_t last_ticket_ = 0;
    bool in_pass_ = false;
    bool delay_ = false;
};

} // namespace hachure::gpu
