#pragma once

namespace hachure {

/// While it lives, SIGINT, SIGTERM and SIGHUP end the program no more at once but at the next `stop_when_interrupted`,
/// so that what is half written can be taken away first; a second one ends it at once. One at a time.
class InterruptWatch {
public:
    InterruptWatch();

    /// Restores what the signals did before; one that came meanwhile does it now.
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;
};

/// Throws Error when a signal came since there is an InterruptWatch.
void stop_when_interrupted();

} // namespace hachure
