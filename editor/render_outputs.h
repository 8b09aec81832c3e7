#pragma once

#include <hachure/editor/frame_plan.h>
#include <hachure/runtime/app/app.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hachure {

/// A buffer of the frame and where it goes.
struct AovOutput {
    std::string name;
    std::filesystem::path file; ///< an EXR file; may number frames
};

/// All that `hachure render` writes. Names may number frames (runtime/assets/frame_pattern.h).
struct RenderOutputs {
    std::filesystem::path picture;
    std::vector<AovOutput> aovs;
    std::filesystem::path stats; ///< empty for none
};

/// Reads `--aov`'s NAME=FILE.exr. Throws UsageError.
[[nodiscard]] std::vector<AovOutput> parse_aovs(const std::vector<std::string>& texts);

/// Before any work: what would fail at its end. Throws UsageError for AOVs that the app does not know, files of other
/// formats, names that do not suit the frames (several into one picture, a film or numbers without frames to show,
/// rates that a GIF can't have), files that would be written twice; Error for folders that can't be written to.
void check_outputs(App& app, const RenderOutputs& outputs, const FramePlan& plan);

/// For `option`, which is about the single frames of a sequence: throws UsageError unless the plan counts frames and
/// every picture and buffer has a number in its name.
void check_sequence(const std::string& option, const RenderOutputs& outputs, const FramePlan& plan);

} // namespace hachure
