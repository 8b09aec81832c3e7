#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hachure {

/// `hachure render`, as the user typed it.
struct RenderOptions {
    std::filesystem::path input;
    std::filesystem::path output;
    std::string style; ///< empty: the scene's own, else gooch
    std::string size;  ///< WIDTHxHEIGHT; empty: that of an image or a video, else 1024x768
    std::string backend = "auto";
    std::vector<std::string> aovs; ///< NAME=FILE.exr
    std::vector<std::string> sets; ///< PATH=VALUE
    std::filesystem::path stats;
    std::string frames; ///< A..B or A; empty: frame 0, or all of a video where the output takes them
    std::string time;   ///< seconds; empty: as the frames say
    std::string fps;    ///< empty: that of a video or of numbered images, else 30
    std::string clip;
    std::string chunk;   ///< I/N; empty: all frames
    bool resume = false; ///< keep the frames of a sequence that are there
    int threads = 0;     ///< at most so many; 0: as many as the hardware runs at once
};

void add_render_command(CLI::App& app, RenderOptions& options);

/// Renders the pictures or the film and writes them, the AOVs and the statistics. Throws Error and UsageError, and ends
/// the program when a signal interrupts it, with nothing half written.
int run_render(const RenderOptions& options);

} // namespace hachure
