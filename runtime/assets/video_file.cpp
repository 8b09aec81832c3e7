#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/error.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

namespace hachure::assets {

struct VideoFile::State {
    std::string name;
    std::unique_ptr<OIIO::ImageInput> input;
    int width = 0, height = 0, frames = 0, channels = 0;
    FrameRate rate{0, 1}; ///< 0: not known
};

VideoFile::VideoFile(const std::filesystem::path& path) : state_(std::make_unique<State>()) {
    State& s = *state_;
    s.name = path.string();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) throw Error(s.name, "is not a file that can be read");
    s.input = OIIO::ImageInput::open(s.name);
    if (!s.input) {
        OIIO::geterror();
        throw Error(s.name, "is not a video that can be read");
    }
    const OIIO::ImageSpec& spec = s.input->spec();
    s.width = spec.width;
    s.height = spec.height;
    s.channels = spec.nchannels;
    if (s.width < 1 || s.height < 1 || std::int64_t{s.width} * s.height > max_image_pixels)
        throw Error(s.name, "has frames of a size that can't be read");
    s.frames = std::max(1, spec.get_int_attribute("oiio:Movie") ? spec.get_int_attribute("oiio:subimages", 1) : 1);
    int rate[2] = {0, 1};
    if (spec.getattribute("FramesPerSecond", OIIO::TypeRational, rate) && rate[0] > 0 && rate[1] > 0) {
        const int divisor = std::gcd(rate[0], rate[1]);
        s.rate = {rate[0] / divisor, rate[1] / divisor};
    }
}

VideoFile::~VideoFile() = default;
VideoFile::VideoFile(VideoFile&&) noexcept = default;
VideoFile& VideoFile::operator=(VideoFile&&) noexcept = default;

int VideoFile::width() const { return state_->width; }
int VideoFile::height() const { return state_->height; }
int VideoFile::frame_count() const { return state_->frames; }
double VideoFile::frames_per_second() const { return static_cast<double>(state_->rate.frames) / state_->rate.seconds; }

std::optional<FrameRate> VideoFile::frame_rate() const {
    const double rate = frames_per_second();
    return rate >= 1.0 && rate <= max_frame_rate ? std::optional(state_->rate) : std::nullopt;
}

Image VideoFile::read_frame(int index) {
    HACHURE_ASSERT(index >= 0 && index < state_->frames, "a frame outside the video");
    State& s = *state_;
    const int channels = std::min(s.channels, 3);
    Image image = make_image(s.width, s.height, channels, PixelType::u8);
    if (!s.input->read_image(index, 0, 0, channels, OIIO::TypeDesc::UINT8, image.pixels.data()))
        throw Error(s.name, "can't be decoded", "frame " + std::to_string(index));
    return image;
}

bool is_video_name(const std::filesystem::path& path) {
    static constexpr std::array<std::string_view, 8> extensions{".mp4",  ".mov", ".avi", ".mkv",
                                                                ".webm", ".mpg", ".m4v", ".ogv"};
    return std::ranges::find(extensions, lower_extension(path)) != extensions.end();
}

} // namespace hachure::assets
