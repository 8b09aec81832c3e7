#include <hachure/tests/runtime/assets/film_reader.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

namespace hachure::test {
namespace {

void check(int result, const char* what) {
    if (result < 0) throw std::runtime_error(what);
}

std::uint8_t byte_of(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0l, 255l)); }

/// ITU-R BT.709-6 read backwards: 8 bits, limited range.
void write_rgb(double y, double cb, double cr, std::uint8_t* rgb) {
    const double luma = (y - 16.0) / 219.0, blue = (cb - 128.0) / 224.0, red = (cr - 128.0) / 224.0;
    const double r = luma + 1.5748 * red, b = luma + 1.8556 * blue;
    const double g = (luma - 0.2126 * r - 0.0722 * b) / 0.7152;
    rgb[0] = byte_of(255.0 * r), rgb[1] = byte_of(255.0 * g), rgb[2] = byte_of(255.0 * b);
}

void take_video(const AVFrame& from, FilmFrame& to) {
    const int halves[3]{1, 2, 2};
    for (std::size_t p = 0; p < 3; ++p)
        for (int y = 0; y < from.height / halves[p]; ++y) {
            const std::uint8_t* row = from.data[p] + y * from.linesize[p];
            to.planes[p].insert(to.planes[p].end(), row, row + from.width / halves[p]);
        }
    std::uint8_t* rgb = to.image.u8();
    for (int y = 0; y < from.height; ++y)
        for (int x = 0; x < from.width; ++x, rgb += 3)
            write_rgb(from.data[0][y * from.linesize[0] + x], from.data[1][y / 2 * from.linesize[1] + x / 2],
                      from.data[2][y / 2 * from.linesize[2] + x / 2], rgb);
}

void take_bgra(const AVFrame& from, FilmFrame& to) {
    std::uint8_t* rgb = to.image.u8();
    for (int y = 0; y < from.height; ++y)
        for (int x = 0; x < from.width; ++x, rgb += 3) {
            const std::uint8_t* bgra = from.data[0] + y * from.linesize[0] + 4 * x;
            rgb[0] = bgra[2], rgb[1] = bgra[1], rgb[2] = bgra[0];
        }
}

/// Everything that FFmpeg has open on a film.
class Reader {
public:
    explicit Reader(const std::filesystem::path& file) {
        AVFormatContext* format = nullptr;
        check(avformat_open_input(&format, file.c_str(), nullptr, nullptr), "no film");
        format_.reset(format);
        check(avformat_find_stream_info(format, nullptr), "no streams");
        check(av_find_best_stream(format, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0), "no video");
        const AVCodecParameters& parameters = *format->streams[0]->codecpar;
        const AVCodec* codec = avcodec_find_decoder(parameters.codec_id);
        decoder_.reset(avcodec_alloc_context3(codec));
        check(avcodec_parameters_to_context(decoder_.get(), &parameters), "no parameters");
        decoder_->thread_count = 1;
        check(avcodec_open2(decoder_.get(), codec, nullptr), "no decoder");
    }

    Film read() {
        Film film = describe();
        while (av_read_frame(format_.get(), packet_.get()) >= 0) {
            check(avcodec_send_packet(decoder_.get(), packet_.get()), "a packet that can't be decoded");
            take_frames(film);
            av_packet_unref(packet_.get());
        }
        check(avcodec_send_packet(decoder_.get(), nullptr), "the end can't be decoded");
        take_frames(film);
        return film;
    }

private:
    Film describe() const {
        const AVCodecParameters& stream = *format_->streams[0]->codecpar;
        Film film;
        film.width = stream.width;
        film.height = stream.height;
        film.duration = static_cast<double>(format_->duration) / AV_TIME_BASE;
        film.matrix = stream.color_space;
        film.primaries = stream.color_primaries;
        film.curve = stream.color_trc;
        film.range = stream.color_range;
        film.siting = stream.chroma_location;
        film.codec = stream.codec_id;
        film.pixel_format = stream.format;
        return film;
    }

    void take_frames(Film& film) {
        const double unit = av_q2d(format_->streams[0]->time_base);
        while (avcodec_receive_frame(decoder_.get(), frame_.get()) >= 0) {
            FilmFrame& frame = film.frames.emplace_back();
            frame.begins = static_cast<double>(frame_->best_effort_timestamp) * unit;
            frame.lasts = static_cast<double>(frame_->pkt_duration) * unit;
            frame.image = assets::make_image(frame_->width, frame_->height, 3, assets::PixelType::u8);
            if (frame_->format == AV_PIX_FMT_YUV420P)
                take_video(*frame_, frame);
            else if (frame_->format == AV_PIX_FMT_BGRA)
                take_bgra(*frame_, frame);
            else
                throw std::runtime_error("a pixel format that nobody expects");
        }
    }

    struct Close {
        void operator()(AVFormatContext* format) const { avformat_close_input(&format); }
        void operator()(AVCodecContext* decoder) const { avcodec_free_context(&decoder); }
        void operator()(AVFrame* frame) const { av_frame_free(&frame); }
        void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    };
    std::unique_ptr<AVFormatContext, Close> format_;
    std::unique_ptr<AVCodecContext, Close> decoder_;
    std::unique_ptr<AVFrame, Close> frame_{av_frame_alloc()};
    std::unique_ptr<AVPacket, Close> packet_{av_packet_alloc()};
};

} // namespace

Film read_film(const std::filesystem::path& file) { return Reader(file).read(); }

} // namespace hachure::test
