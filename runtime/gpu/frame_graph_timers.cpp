#include <hachure/runtime/gpu/frame_graph_timers.h>

#include <iterator>
#include <utility>

namespace hachure::gpu::detail {

void PassTimers::expect(const PassNode& pass, std::uint64_t ticket) {
    if (ticket == 0) return;
    times_[pass.key].idle = 0;
    pending_.push_back({ticket, pass.key});
}

void PassTimers::collect(FrameGraphBackend& backend) {
    std::vector<Pending> late;
    for (const Pending& pending : std::exchange(pending_, {})) {
        if (const auto milliseconds = backend.gpu_ms(pending.ticket)) {
            const auto time = times_.find(pending.pass);
            if (time != times_.end()) time->second.milliseconds = milliseconds;
        } else {
            late.push_back(pending);
        }
    }
    pending_ = std::move(late);
}

std::optional<double> PassTimers::latest(const PassNode& pass) const {
    const auto time = times_.find(pass.key);
    return time == times_.end() ? std::nullopt : time->second.milliseconds;
}

void PassTimers::end_frame(std::uint32_t idle_frames) {
    for (auto time = times_.begin(); time != times_.end();) {
        time = time->second.idle++ < idle_frames ? std::next(time) : times_.erase(time);
    }
}

} // namespace hachure::gpu::detail
