#include <hachure/runtime/app/progress.h>

#include <unistd.h>

#include <cstdio>

namespace hachure {
namespace {

constexpr std::chrono::milliseconds quiet_time{500};

} // namespace

Progress::Progress(std::string_view stage_name)
    : start_(std::chrono::steady_clock::now()), stage_(stage_name), terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (shown_) std::fprintf(stderr, "\r\033[K");
}

void Progress::stage(std::string_view text) {
    stage_ = text;
    show(stage_);
}

void Progress::step(std::size_t done, std::size_t total) {
    show(stage_ + " " + std::to_string(done) + "/" + std::to_string(total));
}

void Progress::show(const std::string& line) {
    if (!terminal_ || std::chrono::steady_clock::now() - start_ < quiet_time) return;
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    std::fflush(stderr);
    shown_ = true;
}

} // namespace hachure
