#include <hachure/editor/interrupt.h>
#include <hachure/runtime/error.h>

#include <array>
#include <csignal>

namespace hachure {
namespace {

constexpr std::array<int, 3> watched{SIGINT, SIGTERM, SIGHUP};
using Handler = void (*)(int);

volatile std::sig_atomic_t caught = 0;
std::array<Handler, watched.size()> earlier{};

/// The second time, the signal does what it always does.
extern "C" void remember(int signal) {
    caught = signal;
    std::signal(signal, SIG_DFL);
}

} // namespace

InterruptWatch::InterruptWatch() {
    caught = 0;
    for (std::size_t i = 0; i < watched.size(); ++i) {
        earlier[i] = std::signal(watched[i], remember);
        if (earlier[i] == SIG_IGN) std::signal(watched[i], SIG_IGN); // as under nohup
    }
}

InterruptWatch::~InterruptWatch() {
    for (std::size_t i = 0; i < watched.size(); ++i) std::signal(watched[i], earlier[i]);
    if (caught != 0) std::raise(caught);
}

void stop_when_interrupted() {
    if (caught != 0) throw Error("interrupted");
}

} // namespace hachure
