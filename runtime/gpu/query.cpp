#include <hachure/runtime/assert.h>
#include <hachure/runtime/gpu/debug_messages.h>
#include <hachure/runtime/gpu/query.h>

namespace hachure::gpu {

Timestamp::Timestamp(std::string_view label) {
    GLuint name = 0;
    gl().CreateQueries(GL_TIMESTAMP, 1, &name);
    handle_ = detail::Handle<&Timestamp::destroy>(name);
    label_object(GL_QUERY, name, label);
}

void Timestamp::destroy(GLuint name) { gl().DeleteQueries(1, &name); }

void Timestamp::record() {
    gl().QueryCounter(name(), GL_TIMESTAMP);
    recorded_ = true;
}

bool Timestamp::ready() const {
    if (!recorded_) return false;
    GLint available = GL_FALSE;
    gl().GetQueryObjectiv(name(), GL_QUERY_RESULT_AVAILABLE, &available);
    return available != GL_FALSE;
}

std::uint64_t Timestamp::nanoseconds() const {
    HACHURE_ASSERT(recorded_, "a timestamp is read before it is recorded");
    GLuint64 time = 0;
    gl().GetQueryObjectui64v(name(), GL_QUERY_RESULT, &time);
    return time;
}

TimerQuery::TimerQuery(std::string_view label) : begin_(label), end_(label) {}

void TimerQuery::begin() {
    HACHURE_ASSERT(state_ != State::running, "a timer begins twice");
    begin_.record();
    state_ = State::running;
}

void TimerQuery::end() {
    HACHURE_ASSERT(state_ == State::running, "a timer ends before it begins");
    end_.record();
    state_ = State::ended;
}

bool TimerQuery::ready() const { return state_ == State::ended && begin_.ready() && end_.ready(); }

double TimerQuery::milliseconds() const {
    HACHURE_ASSERT(state_ == State::ended, "a timer is read before it ends");
    constexpr double milliseconds_per_nanosecond = 1e-6;
    const std::uint64_t begin = begin_.nanoseconds(), end = end_.nanoseconds();
    // Some drivers reset their clock when the GPU wakes up.
    return end > begin ? static_cast<double>(end - begin) * milliseconds_per_nanosecond : 0.0;
}

std::optional<double> TimerQuery::try_milliseconds() const {
    return ready() ? std::optional(milliseconds()) : std::nullopt;
}

} // namespace hachure::gpu
