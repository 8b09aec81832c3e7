#include <hachure/editor/finished_frames.h>
#include <hachure/runtime/assets/frame_pattern.h>
#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/svg_file.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/parallel.h>
#include <hachure/runtime/scene/frame_requests.h>

#include <algorithm>

namespace hachure {
namespace {

constexpr int picture_channels = 3;
constexpr std::size_t block = 32; // frames that are read beside each other before progress is shown

/// A file of each frame, and what is in it.
struct Sequence {
    std::filesystem::path pattern;
    assets::PixelType type;
    int channels;
};

std::vector<Sequence> sequences(App& app, const RenderOutputs& outputs) {
    std::vector<Sequence> result;
    const auto format = assets::frame_format(outputs.picture);
    const bool exr = format == assets::FrameFormat::exr;
    if (format != assets::FrameFormat::svg)
        result.push_back({outputs.picture, exr ? assets::PixelType::f32 : assets::PixelType::u8, picture_channels});
    const std::vector<AovInfo>& known = frame_requests(app.world()).known;
    for (const AovOutput& aov : outputs.aovs) {
        const auto info = std::ranges::find(known, aov.name, &AovInfo::name);
        result.push_back({aov.file, assets::PixelType::f32, static_cast<int>(info->channel_names.size())});
    }
    return result;
}

bool is_whole(const std::filesystem::path& file, const Sequence& sequence, Canvas canvas) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return false;
    try {
        const assets::Image image = assets::read_image(file);
        return image.width == canvas.width && image.height == canvas.height && image.type == sequence.type &&
               image.channels == sequence.channels;
    } catch (const Error&) {
        return false; // cut short, or something else: it is drawn again
    }
}

/// Also where none is to be there.
bool drawing_is_whole(const RenderOutputs& outputs, std::int64_t number, Canvas canvas) {
    return assets::frame_format(outputs.picture) != assets::FrameFormat::svg ||
           assets::is_whole_svg(assets::frame_file(outputs.picture, number), canvas.width, canvas.height);
}

} // namespace

std::vector<std::int64_t> missing_frames(App& app, const RenderOutputs& outputs, const FramePlan& plan, Canvas canvas,
                                         Progress& progress) {
    const std::vector<Sequence> all = sequences(app, outputs);
    const auto count = static_cast<std::size_t>(plan.count());
    std::vector<char> there(count);
    for (std::size_t first = 0; first < count; first += block) {
        progress.step(first, count);
        parallel_for(std::min(block, count - first), [&](std::size_t i) {
            const std::int64_t number = plan.first + static_cast<std::int64_t>(first + i);
            there[first + i] =
                drawing_is_whole(outputs, number, canvas) && std::ranges::all_of(all, [&](const Sequence& sequence) {
                    return is_whole(assets::frame_file(sequence.pattern, number), sequence, canvas);
                });
        });
    }
    std::vector<std::int64_t> missing;
    for (std::size_t i = 0; i < count; ++i)
        if (!there[i]) missing.push_back(plan.first + static_cast<std::int64_t>(i));
    return missing;
}

} // namespace hachure
