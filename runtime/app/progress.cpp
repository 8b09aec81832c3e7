#include <hachure/runtime/app/progress.h>

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace hachure {
namespace {

constexpr std::chrono::milliseconds quiet_time{500};
constexpr std::chrono::milliseconds between_lines{100};

} // namespace

Progress::Progress(std::string_view stage_name)
    : start_(Clock::now()), stage_start_(start_), stage_(stage_name), terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (shown_) std::fprintf(stderr, "\r\033[K");
}

void Progress::stage(std::string_view text) {
    stage_ = text;
    stage_start_ = Clock::now();
    show(stage_);
}

void Progress::step(std::size_t done, std::size_t total) {
    const Clock::time_point now = Clock::now();
    if (!terminal_ || (shown_ && now - shown_at_ < between_lines)) return;
    show(progress_line(stage_, done, total, std::chrono::duration<double>(now - stage_start_).count()));
}

void Progress::show(const std::string& line) {
    const Clock::time_point now = Clock::now();
    if (!terminal_ || now - start_ < quiet_time) return;
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    std::fflush(stderr);
    shown_ = true;
    shown_at_ = now;
}

std::string progress_line(std::string_view stage, std::size_t done, std::size_t total, double seconds) {
    std::string line = fmt::format("{} {}/{}", stage, done, total);
    if (done == 0 || done >= total) return line;
    const double left = seconds / static_cast<double>(done) * static_cast<double>(total - done);
    const auto whole = static_cast<long long>(std::ceil(left));
    if (whole < 3600) return line + fmt::format(", {}:{:02} left", whole / 60, whole % 60);
    return line + fmt::format(", {}:{:02}:{:02} left", whole / 3600, whole / 60 % 60, whole % 60);
}

} // namespace hachure
