#include <hachure/runtime/assert.h>
#include <hachure/runtime/gpu/debug_messages.h>
#include <hachure/runtime/gpu/query.h>

namespace hachure::gpu {
namespace {

constexpr double milliseconds_per_nanosecond = 1e-6;

GLuint create_query(GLenum target, std::string_view label) {
    GLuint name = 0;
    gl().CreateQueries(target, 1, &name);
    label_object(GL_QUERY, name, label);
    return name;
}

bool available(GLuint query) {
    GLint ready = GL_FALSE;
    gl().GetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &ready);
    return ready != GL_FALSE;
}

double result_milliseconds(GLuint query) {
    GLuint64 nanoseconds = 0;
    gl().GetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) * milliseconds_per_nanosecond;
}

} // namespace

TimerQuery::TimerQuery(std::string_view label) : handle_(create_query(GL_TIME_ELAPSED, label)) {}

void TimerQuery::destroy(GLuint name) { gl().DeleteQueries(1, &name); }

void TimerQuery::begin() {
    HACHURE_ASSERT(state_ != State::running, "a timer begins twice");
    gl().BeginQuery(GL_TIME_ELAPSED, name());
    state_ = State::running;
}

void TimerQuery::end() {
    HACHURE_ASSERT(state_ == State::running, "a timer ends before it begins");
    gl().EndQuery(GL_TIME_ELAPSED);
    state_ = State::ended;
}

bool TimerQuery::ready() const { return state_ == State::ended && available(name()); }

double TimerQuery::milliseconds() const {
    HACHURE_ASSERT(state_ == State::ended, "a timer is read before it ends");
    return result_milliseconds(name());
}

std::optional<double> TimerQuery::try_milliseconds() const {
    return ready() ? std::optional(milliseconds()) : std::nullopt;
}

Timestamp::Timestamp(std::string_view label) : handle_(create_query(GL_TIMESTAMP, label)) {}

void Timestamp::destroy(GLuint name) { gl().DeleteQueries(1, &name); }

void Timestamp::record() {
    gl().QueryCounter(name(), GL_TIMESTAMP);
    recorded_ = true;
}

bool Timestamp::ready() const { return recorded_ && available(name()); }

double Timestamp::milliseconds() const {
    HACHURE_ASSERT(recorded_, "a timestamp is read before it is recorded");
    return result_milliseconds(name());
}

} // namespace hachure::gpu
