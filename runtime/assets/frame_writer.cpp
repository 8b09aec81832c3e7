#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/film_writers.h>
#include <hachure/runtime/assets/frame_pattern.h>
#include <hachure/runtime/assets/image_file.h>

#include <utility>

namespace hachure::assets {
namespace {

class PngSequence final : public FrameSequenceWriter {
public:
    explicit PngSequence(std::filesystem::path pattern) : pattern_(std::move(pattern)) {}
    void write(std::int64_t number, const Image& image) override { write_png(frame_file(pattern_, number), image); }
    void finish() override {}

private:
    std::filesystem::path pattern_;
};

class ExrSequence final : public FrameSequenceWriter {
public:
    ExrSequence(std::filesystem::path pattern, std::vector<std::string> channel_names)
        : pattern_(std::move(pattern)), channel_names_(std::move(channel_names)) {}
    void write(std::int64_t number, const Image& image) override {
        write_exr(frame_file(pattern_, number), image, channel_names_);
    }
    void finish() override {}

private:
    std::filesystem::path pattern_;
    std::vector<std::string> channel_names_;
};

} // namespace

std::optional<FrameFormat> frame_format(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    if (extension == ".png") return FrameFormat::png;
    if (extension == ".exr") return FrameFormat::exr;
    if (extension == ".gif") return FrameFormat::gif;
    if (extension == ".mp4") return FrameFormat::mp4;
    if (extension == ".svg") return FrameFormat::svg;
    return {};
}

std::unique_ptr<FrameSequenceWriter> make_frame_writer(const std::filesystem::path& file,
                                                       const FrameWriterOptions& options) {
    const std::optional<FrameFormat> format = frame_format(file);
    HACHURE_ASSERT(format && *format != FrameFormat::svg, "the extension is one that images are written to");
    switch (*format) {
    case FrameFormat::png:
        return std::make_unique<PngSequence>(file);
    case FrameFormat::exr:
        return std::make_unique<ExrSequence>(file, options.channel_names);
    case FrameFormat::gif:
        return make_gif_writer(file, options.rate);
    case FrameFormat::mp4:
    case FrameFormat::svg:
        break;
    }
    return make_mp4_writer(file, options.rate);
}

} // namespace hachure::assets
