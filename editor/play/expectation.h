#pragma once

#include <hachure/editor/play/play_result.h>
#include <hachure/editor/play/played_frame.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hachure::play {

/// Frames of a test, both ends included.
struct FrameRange {
    std::int64_t first = 0, last = 0;
    [[nodiscard]] bool contains(std::int64_t frame) const { return frame >= first && frame <= last; }
};

/// What an expectation needs of the frames that it looks at.
enum class FrameNeed {
    nothing,     ///< it looks at none
    logic,       ///< that the systems ran
    drawn,       ///< that it was drawn
    drawn_twice, ///< that it and the frame before it were drawn
};

/// What is measured apart from the run.
enum class TimeOf { frame, load };

/// How and where expectations are judged, after the last frame.
struct JudgeContext {
    bool update = false;            ///< write golden pictures anew
    std::filesystem::path evidence; ///< a folder for pictures; empty when nobody wants any
    std::string stem;               ///< of the names of files there
    std::int64_t from = 0;          ///< frames before this one were not looked at

    /// Plays the test's scene with more assignments and says how long a frame, or opening it, takes at best, seconds.
    std::function<double(TimeOf of, const std::vector<std::string>& more_sets)> measure;
};

/// Something that must hold in a run: it looks at frames as they come, and judges at the end.
class Expectation {
public:
    Expectation(std::string kind, std::string pointer, FrameRange frames)
        : kind_(std::move(kind)), pointer_(std::move(pointer)), frames_(frames) {}
    virtual ~Expectation() = default;
    Expectation(const Expectation&) = delete;
    Expectation& operator=(const Expectation&) = delete;

    [[nodiscard]] const std::string& kind() const { return kind_; }
    [[nodiscard]] FrameRange frames() const { return frames_; }

    [[nodiscard]] virtual FrameNeed need() const = 0;

    /// A buffer that it reads, or empty.
    [[nodiscard]] virtual std::string aov() const { return {}; }
    [[nodiscard]] virtual bool counts_allocations() const { return false; }

    /// Takes a frame in its range; they come in order. Throws Error for what ends the run.
    virtual void look(PlayedFrame& frame) = 0;

    /// What came of it, once the run is over.
    [[nodiscard]] ExpectationResult result(const JudgeContext& context);

    /// The same when the run ended before its end, for `reason`.
    [[nodiscard]] ExpectationResult unjudged(std::string reason) const;

    /// The first frame that failed; the first that it looks at when none did.
    [[nodiscard]] std::int64_t first_look() const { return failures_ > 0 ? failed_frame_ : frames_.first; }

protected:
    /// In words, after "frame N" or "frames A to B".
    [[nodiscard]] virtual std::string what() const = 0;

    /// Fills in what is special: figures where it passed (reason), evidence, curves, further failures.
    virtual void judge(const JudgeContext& context, ExpectationResult& result) = 0;

    /// Notes a failure at a frame; the first one is told.
    void fail(std::int64_t frame, const std::string& reason);

private:
    std::string kind_, pointer_, first_failure_;
    FrameRange frames_;
    std::int64_t failures_ = 0, failed_frame_ = 0;
};

} // namespace hachure::play
