#include <hachure/editor/play/worst_frames.h>
#include <hachure/runtime/assets/image_file.h>

namespace hachure::play {
namespace {

constexpr std::size_t frames_before = 3; // the worst one included
constexpr int frames_after = 3;

} // namespace

void WorstFrames::add(const assets::Image& frame, double badness) {
    recent_.push_back(frame);
    if (recent_.size() > frames_before) recent_.pop_front();
    if (badness > worst_) {
        worst_ = badness;
        kept_.assign(recent_.begin(), recent_.end());
        missing_ = frames_after;
    } else if (missing_ > 0) {
        kept_.push_back(frame);
        --missing_;
    }
}

std::vector<std::filesystem::path> WorstFrames::write(const std::filesystem::path& folder,
                                                      const std::string& stem) const {
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i < kept_.size() && !folder.empty(); ++i) {
        files.push_back(folder / (stem + "-" + std::to_string(i) + ".png"));
        assets::write_png(files.back(), kept_[i]);
    }
    return files;
}

} // namespace hachure::play
