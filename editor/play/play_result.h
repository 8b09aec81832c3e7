#pragma once

#include <hachure/runtime/assets/image.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What a playback test showed: made by the runner, passed between processes, read by the report.
namespace hachure::play {

/// Values over frames, and what was allowed of them.
struct Curve {
    std::string name; ///< "popping", "Fox/transform.translation.x"
    std::string unit; ///< may be empty
    std::int64_t first_frame = 0;
    std::vector<double> values; ///< one per frame
    std::optional<double> at_least, at_most;
};

/// A picture that was held against another one; paths of PNG files. Those that do not exist are empty.
struct PictureEvidence {
    std::filesystem::path golden, actual, difference; ///< difference: brighter is further off
    double max_difference = 0.0;                      ///< 255ths
    double differing_share = 0.0;                     ///< of the pixels
    double flip_p99 = 0.0, flip_max = 0.0;
    double line_distance = 0.0; ///< pixels; infinite where only one picture has lines
};

/// One expectation of a test and what came of it.
struct ExpectationResult {
    std::string kind;    ///< as the play file calls it: "picture", "field", "flicker", ...
    std::string what;    ///< in words: "frame 30 looks like golden/fox.png"
    std::string pointer; ///< JSON pointer of the expectation in the play file
    bool passed = false;
    bool renewed = false; ///< the golden picture was written by --update
    std::string reason;   ///< one line; why it failed, or the figures where it passed
    std::int64_t first_frame = 0, last_frame = 0;
    std::optional<PictureEvidence> picture;
    std::vector<Curve> curves;
    std::vector<std::filesystem::path> frames; ///< PNG files of consecutive frames: for flicker and popping
};

/// What a pass did over all frames.
struct PassSummary {
    std::string name;
    std::int64_t run = 0, reused = 0, culled = 0; ///< frames
    double cpu_ms = 0.0, gpu_ms = 0.0;            ///< sums
};

/// A frame of the film strip.
struct StripFrame {
    std::int64_t frame = 0;
    std::filesystem::path picture; ///< PNG, at most 240 pixels wide
};

struct PlayResult {
    std::filesystem::path file; ///< the .play.json
    std::string doc;            ///< what it shows, one line; may be empty
    bool passed = false;        ///< all expectations did, and nothing went wrong
    std::string error;          ///< what went wrong beside expectations: a bad file, a script error, a crash
    double seconds = 0.0;       ///< wall clock
    std::int64_t frames = 0;    ///< that were played
    int width = 0, height = 0;
    std::string renderer; ///< of the driver
    std::vector<std::string> log;
    std::vector<ExpectationResult> expectations;
    std::vector<PassSummary> passes;
    std::vector<StripFrame> strip;
    std::vector<Curve> curves; ///< of the whole run: milliseconds a frame, say
    std::string replay;        ///< a shell command that plays up to its first failing frame, or all of it
};

} // namespace hachure::play
