#include <hachure/editor/render_outputs.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/frame_pattern.h>
#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/frame_requests.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unordered_set>

namespace hachure {
namespace {

void check_aov_names(App& app, const std::vector<AovOutput>& aovs) {
    const std::vector<AovInfo>& known = frame_requests(app.world()).known;
    for (const AovOutput& aov : aovs)
        if (std::ranges::find(known, aov.name, &AovInfo::name) == known.end())
            throw UsageError("--aov: there is no AOV '" + aov.name + "' (see hachure list aovs)");
}

/// Films hold all frames.
void check_film(const std::filesystem::path& file, assets::FrameFormat format, const FramePlan& plan) {
    const std::string start = "-o: '" + file.string() + "' ";
    if (assets::count_number_fields(file) > 0) throw UsageError(start + "holds all frames: it takes no # in its name");
    if (!plan.numbered) throw UsageError(start + "is a film: say which frames it shows, --frames A..B");
    if (format == assets::FrameFormat::gif && plan.rate.frames > std::int64_t{assets::max_gif_rate} * plan.rate.seconds)
        throw UsageError("--fps: a GIF shows at most " + std::to_string(assets::max_gif_rate) + " frames a second");
}

/// Pictures hold one frame, or have a name for each.
void check_picture(const std::string& option, const std::filesystem::path& file, const FramePlan& plan) {
    const std::string start = option + ": '" + file.string() + "' ";
    const int fields = assets::count_number_fields(file);
    if (fields > 1) throw UsageError(start + "has more than one run of # in its name");
    if (fields == 1 && plan.time) throw UsageError(start + "numbers frames, and --time has none: use --frames");
    if (fields == 0 && plan.count() > 1)
        throw UsageError(start + "holds one frame, not " + std::to_string(plan.count()) + ": name it " +
                         file.stem().string() + ".####" + file.extension().string());
}

void check_formats(const RenderOutputs& outputs, const FramePlan& plan) {
    const auto format = assets::frame_format(outputs.picture);
    if (!format)
        throw UsageError("-o: '" + outputs.picture.string() + "' is neither a .png, .exr, .svg, .gif nor .mp4 file");
    if (assets::is_film(*format))
        check_film(outputs.picture, *format, plan);
    else
        check_picture("-o", outputs.picture, plan);
    for (const AovOutput& aov : outputs.aovs) check_picture("--aov", aov.file, plan);
}

void check_writable(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.parent_path().empty() ? "." : file.parent_path();
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw Error(file.string(), "can't be written: there is no such folder");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw Error(file.string(), "can't be written", std::strerror(errno));
    if (std::filesystem::is_directory(file, ignored)) throw Error(file.string(), "is a folder, not a file to write");
}

} // namespace

std::vector<AovOutput> parse_aovs(const std::vector<std::string>& texts) {
    std::vector<AovOutput> outputs;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
            throw UsageError("--aov: '" + text + "' is not NAME=FILE.exr");
        outputs.push_back({text.substr(0, equals), text.substr(equals + 1)});
        if (assets::lower_extension(outputs.back().file) != ".exr")
            throw UsageError("--aov: '" + outputs.back().file.string() + "' is not an .exr file");
    }
    return outputs;
}

void check_outputs(App& app, const RenderOutputs& outputs, const FramePlan& plan) {
    check_aov_names(app, outputs.aovs);
    check_formats(outputs, plan);
    std::vector<std::filesystem::path> patterns{outputs.picture};
    for (const AovOutput& aov : outputs.aovs) patterns.push_back(aov.file);
    if (!outputs.stats.empty()) patterns.push_back(outputs.stats);
    std::unordered_set<std::string> files;
    for (const std::filesystem::path& pattern : patterns) {
        const bool numbered = assets::count_number_fields(pattern) > 0 && pattern != outputs.stats;
        for (std::int64_t i = 0; i < (numbered ? plan.count() : 1); ++i) {
            const std::filesystem::path file = numbered ? assets::frame_file(pattern, plan.first + i) : pattern;
            if (!files.insert(file.lexically_normal().string()).second)
                throw UsageError("'" + file.string() + "' would be written twice");
            if (i == 0) check_writable(file);
        }
    }
}

void check_sequence(const std::string& option, const RenderOutputs& outputs, const FramePlan& plan) {
    if (!plan.numbered) throw UsageError(option + ": say which frames the sequence has, --frames A..B");
    std::vector<std::filesystem::path> patterns{outputs.picture};
    for (const AovOutput& aov : outputs.aovs) patterns.push_back(aov.file);
    for (const std::filesystem::path& pattern : patterns)
        if (assets::count_number_fields(pattern) == 0)
            throw UsageError(option + ": is for numbered pictures, out.####.png, and '" + pattern.string() +
                             "' is none");
}

} // namespace hachure
