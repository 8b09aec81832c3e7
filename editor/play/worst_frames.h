#pragma once

#include <hachure/runtime/assets/image.h>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace hachure::play {

/// Keeps the frames around the worst moment of a sequence, to show them.
class WorstFrames {
public:
    /// Takes the next frame and how bad it is.
    void add(const assets::Image& frame, double badness);

    /// Writes what was kept as PNG files FOLDER/STEM-0.png, ...; returns them. None when `folder` is empty.
    [[nodiscard]] std::vector<std::filesystem::path> write(const std::filesystem::path& folder,
                                                           const std::string& stem) const;

private:
    std::deque<assets::Image> recent_;
    std::vector<assets::Image> kept_;
    double worst_ = -1.0;
    int missing_ = 0; ///< frames after the worst that are still to come
};

} // namespace hachure::play
