#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/assets/video_pixels.h>
#include <hachure/runtime/error.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/log.h>
}

namespace hachure::assets {
namespace {

constexpr double usual_rate = 30.0; // frames per second of a file that does not say

/// Contents decide what a file is, and a playlist among them could make us read other files, or the net.
constexpr const char* formats = "mov,matroska,avi,mpeg,mpegts,ogg,gif";

struct Close {
    void operator()(AVFormatContext* format) const { avformat_close_input(&format); }
    void operator()(AVCodecContext* decoder) const { avcodec_free_context(&decoder); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
template <class T> using Owned = std::unique_ptr<T, Close>;

/// A frame that is decoded without those before it.
struct KeyFrame {
    std::int64_t shown, decoded; ///< units of the stream
};

} // namespace

struct VideoFile::State {
    explicit State(const std::filesystem::path& path) : name(path.string()) {
        if (av_log_get_level() == AV_LOG_INFO) av_log_set_level(AV_LOG_QUIET); // our errors say it
        open();
        const AVStream& video = *format->streams[stream];
        width = video.codecpar->width;
        height = video.codecpar->height;
        if (width < 1 || height < 1 || std::int64_t{width} * height > max_image_pixels)
            throw Error(name, "has frames of a size that can't be read");
        const AVRational average = video.avg_frame_rate.num > 0 ? video.avg_frame_rate : video.r_frame_rate;
        if (average.num > 0 && average.den > 0) {
            const int divisor = std::gcd(average.num, average.den);
            rate = {average.num / divisor, average.den / divisor};
        }
        read_times();
        open();
    }

    /// From the beginning.
    void open() {
        AVFormatContext* opened = nullptr;
        AVDictionary* options = nullptr;
        av_dict_set(&options, "format_whitelist", formats, 0);
        av_dict_set(&options, "protocol_whitelist", "file", 0);
        const int result = avformat_open_input(&opened, ("file:" + name).c_str(), nullptr, &options);
        av_dict_free(&options);
        format.reset(opened);
        if (result < 0 || avformat_find_stream_info(format.get(), nullptr) < 0)
            throw Error(name, "is not a video that can be read");
        const AVCodec* codec = nullptr;
        const int found = av_find_best_stream(format.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
        if (found < 0) throw Error(name, "is not a video that can be read");
        stream = static_cast<unsigned>(found);
        decoder.reset(avcodec_alloc_context3(codec));
        decoder->thread_count = 0;
        if (avcodec_parameters_to_context(decoder.get(), format->streams[stream]->codecpar) < 0 ||
            avcodec_open2(decoder.get(), codec, nullptr) < 0)
            throw Error(name, "is not a video that can be read");
        begin();
    }

    /// Of all frames, without decoding them.
    void read_times() {
        std::int64_t packets = 0;
        for (; av_read_frame(format.get(), packet.get()) >= 0; av_packet_unref(packet.get())) {
            if (packet->stream_index != static_cast<int>(stream)) continue;
            ++packets;
            if ((packet->flags & AV_PKT_FLAG_DISCARD) != 0) continue; // cut off by an edit of the file
            counted = counted || packet->pts == AV_NOPTS_VALUE;
            times.push_back(packet->pts);
            if ((packet->flags & AV_PKT_FLAG_KEY) != 0 && packet->dts != AV_NOPTS_VALUE)
                keys.push_back({packet->pts, packet->dts});
        }
        if (times.empty()) throw Error(name, "has no frame that can be read");
        if (format->streams[stream]->nb_frames > packets)
            throw Error(name, "is cut short: it has " + std::to_string(packets) + " of " +
                                  std::to_string(format->streams[stream]->nb_frames) + " frames");
        if (counted) {
            std::iota(times.begin(), times.end(), 0);
            keys.clear();
        }
        std::ranges::sort(times);
        std::ranges::sort(keys, {}, &KeyFrame::shown);
    }

    /// Forgets what was decoded.
    void begin() {
        any = ended = false;
        decoded = 0;
    }

    /// Decodes the next frame, in the order in which they are shown. False after the last one.
    bool next() {
        for (;;) {
            const int result = avcodec_receive_frame(decoder.get(), frame.get());
            if (result >= 0) {
                shown = counted ? decoded : frame->best_effort_timestamp;
                ++decoded;
                return any = true;
            }
            if (result != AVERROR(EAGAIN) || ended) return false;
            feed();
        }
    }

    /// Hands the decoder a packet, or the end. Packets that it refuses are left out: who asks for their frame is told.
    void feed() {
        while (av_read_frame(format.get(), packet.get()) >= 0) {
            const bool ours = packet->stream_index == static_cast<int>(stream);
            const int result = ours ? avcodec_send_packet(decoder.get(), packet.get()) : -1;
            av_packet_unref(packet.get());
            if (ours && result >= 0) return;
        }
        ended = avcodec_send_packet(decoder.get(), nullptr) < 0;
    }

    /// The last key frame that is not after `time`, where the file has one.
    [[nodiscard]] const KeyFrame* key_before(std::int64_t time) const {
        const auto after = std::ranges::upper_bound(keys, time, {}, &KeyFrame::shown);
        return after == keys.begin() ? nullptr : &*std::prev(after);
    }

    /// Decodes up to the frame of that time. False when there is none on the way.
    bool reach(std::int64_t time) {
        while (!any || shown < time)
            if (!next()) return any = false;
        return shown == time;
    }

    /// Goes to the key frame before `time`. False when the file can't.
    bool seek(std::int64_t time) {
        const KeyFrame* key = key_before(time);
        if (!key || av_seek_frame(format.get(), static_cast<int>(stream), key->decoded, AVSEEK_FLAG_BACKWARD) < 0)
            return false;
        avcodec_flush_buffers(decoder.get());
        begin();
        return true;
    }

    /// Makes `frame` the one of that time: by going on where no key frame is nearer, by seeking, or from the beginning.
    bool go_to(std::int64_t time) {
        const KeyFrame* key = key_before(time);
        if (any && shown <= time && (!key || key->shown <= shown) && reach(time)) return true;
        if (seek(time) && reach(time)) return true;
        open();
        return reach(time);
    }

    std::string name;
    Owned<AVFormatContext> format;
    Owned<AVCodecContext> decoder;
    Owned<AVFrame> frame{av_frame_alloc()};
    Owned<AVPacket> packet{av_packet_alloc()};
    unsigned stream = 0;
    int width = 0, height = 0;
    FrameRate rate{0, 1};            ///< 0: not known
    bool counted = false;            ///< the file gives no times: frames are numbered
    std::vector<std::int64_t> times; ///< of all frames, units of the stream, ascending
    std::vector<KeyFrame> keys;      ///< ascending
    bool any = false;                ///< `frame` holds one, shown at `shown`
    bool ended = false;              ///< the decoder has all there is
    std::int64_t shown = 0, decoded = 0;
};

VideoFile::VideoFile(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) throw Error(path.string(), "is not a file that can be read");
    state_ = std::make_unique<State>(path);
}

VideoFile::~VideoFile() = default;
VideoFile::VideoFile(VideoFile&&) noexcept = default;
VideoFile& VideoFile::operator=(VideoFile&&) noexcept = default;

int VideoFile::width() const { return state_->width; }
int VideoFile::height() const { return state_->height; }
int VideoFile::frame_count() const { return static_cast<int>(state_->times.size()); }
double VideoFile::frames_per_second() const { return static_cast<double>(state_->rate.frames) / state_->rate.seconds; }

std::optional<FrameRate> VideoFile::frame_rate() const {
    const double rate = frames_per_second();
    return rate >= 1.0 && rate <= max_frame_rate ? std::optional(state_->rate) : std::nullopt;
}

double VideoFile::duration() const {
    const State& s = *state_;
    const double rate = s.rate.frames > 0 ? frames_per_second() : usual_rate;
    if (s.counted) return frame_count() / rate;
    return static_cast<double>(s.times.back() - s.times.front()) * av_q2d(s.format->streams[s.stream]->time_base) +
           1.0 / rate;
}

int VideoFile::frame_at(double seconds) const {
    const State& s = *state_;
    const double rate = s.rate.frames > 0 ? frames_per_second() : usual_rate;
    const double unit = s.counted ? 1.0 / rate : av_q2d(s.format->streams[s.stream]->time_base);
    const double time = static_cast<double>(s.times.front()) + (seconds + 0.1 / rate) / unit;
    const auto after = std::ranges::upper_bound(s.times, time, {}, [](std::int64_t t) { return double(t); });
    return std::max(0, static_cast<int>(after - s.times.begin()) - 1);
}

Image VideoFile::read_frame(int index) {
    HACHURE_ASSERT(index >= 0 && index < frame_count(), "a frame outside the video");
    State& s = *state_;
    const std::string where = "frame " + std::to_string(index);
    if (!s.go_to(s.times[static_cast<std::size_t>(index)])) throw Error(s.name, "can't be decoded", where);
    std::optional<Image> image = video_pixels(*s.frame, s.width, s.height);
    if (!image) throw Error(s.name, "has pixels of a kind that is not read", where);
    return std::move(*image);
}

bool is_video_name(const std::filesystem::path& path) {
    static constexpr std::array<std::string_view, 8> extensions{".mp4",  ".mov", ".avi", ".mkv",
                                                                ".webm", ".mpg", ".m4v", ".ogv"};
    return std::ranges::find(extensions, lower_extension(path)) != extensions.end();
}

} // namespace hachure::assets
