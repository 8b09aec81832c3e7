#pragma once

#include <hachure/runtime/gpu/handle.h>

#include <optional>
#include <string_view>

namespace hachure::gpu {

/// GPU time between begin() and end() (GL_TIME_ELAPSED). Timers do not nest, not even different ones.
class TimerQuery {
public:
    TimerQuery() = default;
    explicit TimerQuery(std::string_view label);

    void begin(); ///< glBeginQuery
    void end();   ///< glEndQuery

    /// Whether the last begin/end pair has its result; never waits (GL_QUERY_RESULT_AVAILABLE). False before the first.
    [[nodiscard]] bool ready() const;
    /// Milliseconds of the last pair; waits for the GPU (GL_QUERY_RESULT). Asserts that there was one.
    [[nodiscard]] double milliseconds() const;
    /// Milliseconds if ready(), else nothing.
    [[nodiscard]] std::optional<double> try_milliseconds() const;

    [[nodiscard]] GLuint name() const { return handle_.get(); }

private:
    enum class State : unsigned char { idle, running, ended };

    static void destroy(GLuint name);
    detail::Handle<&TimerQuery::destroy> handle_;
    State state_ = State::idle;
};

/// The GPU's clock when it reaches a point in the calls (glQueryCounter). Two of them time what lies between, and may
/// enclose other timers.
class Timestamp {
public:
    Timestamp() = default;
    explicit Timestamp(std::string_view label);

    void record();
    [[nodiscard]] bool ready() const; ///< never waits; false before the first record()
    /// Milliseconds since a fixed point of the driver's; waits for the GPU. Asserts that there was a record().
    [[nodiscard]] double milliseconds() const;

    [[nodiscard]] GLuint name() const { return handle_.get(); }

private:
    static void destroy(GLuint name);
    detail::Handle<&Timestamp::destroy> handle_;
    bool recorded_ = false;
};

} // namespace hachure::gpu
