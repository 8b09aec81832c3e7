#include <hachure/editor/frame_output.h>
#include <hachure/editor/stroke_drawing.h>
#include <hachure/runtime/assets/frame_pattern.h>
#include <hachure/runtime/assets/svg_file.h>
#include <hachure/runtime/parallel.h>
#include <hachure/runtime/scene/frame_requests.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace hachure {
namespace {

/// Frames that wait while another one is written: enough to even out what frames cost, few enough to hold in memory.
constexpr std::size_t frames_waiting = 2;

std::size_t queue_limit(const FramePlan& plan) { return plan.count() > 1 && thread_limit() > 1 ? frames_waiting : 0; }

std::vector<std::string> channel_names(App& app, const std::string& aov) {
    const std::vector<AovInfo>& known = app.world().resource<FrameRequests>().known;
    return std::ranges::find(known, aov, &AovInfo::name)->channel_names;
}

} // namespace

FrameOutput::FrameOutput(App& app, Renderer& renderer, const RenderOutputs& outputs, const FramePlan& plan)
    : app_(&app), renderer_(&renderer), queue_(queue_limit(plan)) {
    std::vector<AovOutput> all = outputs.aovs;
    const auto format = assets::frame_format(outputs.picture);
    if (format == assets::FrameFormat::svg) {
        drawing_ = outputs.picture;
        want_strokes(app.world(), drawing_.string());
    } else {
        all.push_back({format == assets::FrameFormat::exr ? "color" : "", outputs.picture});
    }
    for (const AovOutput& output : all) {
        assets::FrameWriterOptions options{plan.rate, {}};
        if (!output.name.empty()) {
            renderer.request_aov(output.name);
            options.channel_names = channel_names(app, output.name);
        }
        targets_.push_back({output.name, assets::make_frame_writer(output.file, options)});
    }
}

void FrameOutput::take(std::int64_t number) {
    std::vector<assets::Image> images;
    for (const Target& target : targets_)
        images.push_back(target.aov.empty() ? renderer_->read_picture() : renderer_->read_aov(target.aov));
    std::optional<assets::SvgDrawing> drawing;
    if (!drawing_.empty()) drawing = stroke_drawing(app_->world());
    queue_.push([this, number, images = std::move(images), drawing = std::move(drawing)] {
        if (drawing) assets::write_svg(assets::frame_file(drawing_, number), *drawing);
        for (std::size_t i = 0; i < targets_.size(); ++i) targets_[i].writer->write(number, images[i]);
    });
}

void FrameOutput::finish() {
    queue_.finish();
    for (const Target& target : targets_) target.writer->finish();
}

} // namespace hachure
