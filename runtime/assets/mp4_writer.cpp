#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/film_writers.h>
#include <hachure/runtime/assets/yuv420.h>
#include <hachure/runtime/error.h>

#include <array>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/error.h>
#include <libavutil/log.h>
#include <libavutil/opt.h>
}

namespace hachure::assets {
namespace {

/// Of the encoder. The stream depends on the number, so it is the same everywhere.
constexpr int encoder_threads = 4;

/// FFmpeg tells stderr about every film, unless the program has told it how much it wants to hear.
void quiet_log() {
    if (av_log_get_level() == AV_LOG_INFO) av_log_set_level(AV_LOG_QUIET);
}

struct FreeFormat {
    void operator()(AVFormatContext* format) const {
        if (format->pb) avio_closep(&format->pb);
        avformat_free_context(format);
    }
};
struct FreeEncoder {
    void operator()(AVCodecContext* encoder) const { avcodec_free_context(&encoder); }
};
struct FreeFrame {
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct FreePacket {
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};

/// H.264 in MP4 through FFmpeg's libraries.
class Mp4Writer final : public FrameSequenceWriter {
public:
    Mp4Writer(const std::filesystem::path& file, FrameRate rate) : file_(file), rate_(rate) {}

    void write(std::int64_t, const Image& image) override {
        HACHURE_ASSERT(image.type == PixelType::u8 && image.channels >= 3, "a film is written from 8-bit RGB images");
        if (!encoder_) open(image);
        HACHURE_ASSERT(image.width == width_ && image.height == height_, "a film's frames have one size");
        check(av_frame_make_writable(frame_.get()));
        convert(image);
        frame_->pts = frames_++;
        check(avcodec_send_frame(encoder_.get(), frame_.get()));
        drain();
    }

    void finish() override {
        HACHURE_ASSERT(frames_ > 0, "a film has a frame");
        check(avcodec_send_frame(encoder_.get(), nullptr));
        drain();
        check(av_write_trailer(format_.get()));
        check(avio_closep(&format_->pb));
        file_.commit();
    }

private:
    [[noreturn]] void fail(std::string_view fault, std::string_view where = {}) const {
        throw Error(file_.target().string(), fault, where);
    }

    void check(int result) const {
        if (result >= 0) return;
        std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
        av_strerror(result, text.data(), text.size());
        fail("can't be written", text.data());
    }

    void open(const Image& image) {
        width_ = image.width;
        height_ = image.height;
        quiet_log();
        AVFormatContext* format = nullptr;
        check(avformat_alloc_output_context2(&format, nullptr, "mp4", ("file:" + file_.temporary_name()).c_str()));
        format_.reset(format);
        format->flags |= AVFMT_FLAG_BITEXACT; // no names of versions in the file
        open_encoder();
        stream_ = avformat_new_stream(format, nullptr);
        frame_.reset(av_frame_alloc());
        packet_.reset(av_packet_alloc());
        if (!stream_ || !frame_ || !packet_) fail("can't be written", "not enough memory");
        stream_->time_base = encoder_->time_base;
        stream_->avg_frame_rate = encoder_->framerate;
        check(avcodec_parameters_from_context(stream_->codecpar, encoder_.get()));
        make_frame();
        check(avio_open(&format->pb, format->url, AVIO_FLAG_WRITE));
        AVDictionary* options = nullptr;
        av_dict_set(&options, "movflags", "+faststart+write_colr", 0);
        const int result = avformat_write_header(format, &options);
        av_dict_free(&options);
        check(result);
    }

    void open_encoder() {
        const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
        if (!codec) fail("can't be written: FFmpeg has no H.264 encoder here", "libx264");
        encoder_.reset(avcodec_alloc_context3(codec));
        if (!encoder_) fail("can't be written", "not enough memory");
        AVCodecContext& encoder = *encoder_;
        encoder.width = even_size(width_);
        encoder.height = even_size(height_);
        encoder.pix_fmt = AV_PIX_FMT_YUV420P;
        encoder.time_base = {rate_.seconds, rate_.frames};
        encoder.framerate = {rate_.frames, rate_.seconds};
        encoder.sample_aspect_ratio = {1, 1};
        // The values are sRGB's own: BT.709 names the same primaries, but another curve, which some players undo.
        encoder.color_primaries = AVCOL_PRI_BT709;
        encoder.color_trc = AVCOL_TRC_IEC61966_2_1;
        encoder.colorspace = AVCOL_SPC_BT709;
        encoder.color_range = AVCOL_RANGE_MPEG;
        encoder.chroma_sample_location = AVCHROMA_LOC_LEFT;
        encoder.thread_count = encoder_threads;
        encoder.flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
        check(av_opt_set(encoder.priv_data, "preset", "medium", 0));
        check(av_opt_set(encoder.priv_data, "crf", "18", 0));
        // The same stream on every processor.
        check(av_opt_set(encoder.priv_data, "x264-params", "cpu-independent=1", 0));
        check(avcodec_open2(&encoder, codec, nullptr));
    }

    void make_frame() {
        frame_->format = encoder_->pix_fmt;
        frame_->width = encoder_->width;
        frame_->height = encoder_->height;
        check(av_frame_get_buffer(frame_.get(), 0));
    }

    BytePlane plane(int index, int height) const {
        const auto stride = static_cast<std::size_t>(frame_->linesize[index]);
        return {{frame_->data[index], stride * static_cast<std::size_t>(height)}, stride};
    }

    void convert(const Image& image) const {
        const int height = encoder_->height;
        const ConvertToYuv420 job{.pixels = {image.u8(), image.pixels.size()},
                                  .width = image.width,
                                  .height = image.height,
                                  .channels = image.channels,
                                  .luma = plane(0, height),
                                  .blue = plane(1, height / 2),
                                  .red = plane(2, height / 2)};
        job.validate();
        job.run();
    }

    /// Writes what the encoder has ready.
    void drain() {
        for (;;) {
            const int result = avcodec_receive_packet(encoder_.get(), packet_.get());
            if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
            check(result);
            packet_->duration = 1;
            packet_->stream_index = stream_->index;
            av_packet_rescale_ts(packet_.get(), encoder_->time_base, stream_->time_base);
            check(av_interleaved_write_frame(format_.get(), packet_.get()));
        }
    }

    AtomicFile file_; // outlives the format, which has it open
    FrameRate rate_;
    int width_ = 0, height_ = 0;
    std::int64_t frames_ = 0;
    AVStream* stream_ = nullptr; // the format's
    std::unique_ptr<AVFormatContext, FreeFormat> format_;
    std::unique_ptr<AVCodecContext, FreeEncoder> encoder_;
    std::unique_ptr<AVFrame, FreeFrame> frame_;
    std::unique_ptr<AVPacket, FreePacket> packet_;
};

} // namespace

std::unique_ptr<FrameSequenceWriter> make_mp4_writer(const std::filesystem::path& file, FrameRate rate) {
    return std::make_unique<Mp4Writer>(file, rate);
}

} // namespace hachure::assets
