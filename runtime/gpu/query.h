#pragma once

#include <hachure/runtime/gpu/handle.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace hachure::gpu {

/// The GPU's clock when it reaches a point in the calls (glQueryCounter).
class Timestamp {
public:
    Timestamp() = default;
    explicit Timestamp(std::string_view label);

    void record();
    [[nodiscard]] bool ready() const; ///< never waits (GL_QUERY_RESULT_AVAILABLE); false before the first record()
    /// Nanoseconds since a fixed point of the driver's; waits for the GPU (GL_QUERY_RESULT). Asserts that there was a
    /// record().
    [[nodiscard]] std::uint64_t nanoseconds() const;

    [[nodiscard]] GLuint name() const { return handle_.get(); }

private:
    static void destroy(GLuint name);
    detail::Handle<&Timestamp::destroy> handle_;
    bool recorded_ = false;
};

/// GPU time between begin() and end(): the difference of two timestamps. GL_TIME_ELAPSED is not used because it cannot
/// nest, and because llvmpipe leaves out of it what came before the last change of framebuffer.
class TimerQuery {
public:
    TimerQuery() = default;
    explicit TimerQuery(std::string_view label);

    void begin();
    void end();

    /// Whether the last begin/end pair has its result; never waits. False before the first.
    [[nodiscard]] bool ready() const;
    /// Milliseconds of the last pair; waits for the GPU. Asserts that there was one.
    [[nodiscard]] double milliseconds() const;
    /// Milliseconds if ready(), else nothing.
    [[nodiscard]] std::optional<double> try_milliseconds() const;

private:
    enum class State : std::uint8_t { idle, running, ended };

    Timestamp begin_;
    Timestamp end_;
    State state_ = State::idle;
};

} // namespace hachure::gpu
