#include <hachure/runtime/assets/video_pixels.h>
#include <hachure/runtime/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
}

namespace hachure::assets {
namespace {

/// The weights of red and blue in luma.
struct LumaWeights {
    float red, blue;
};

LumaWeights luma_weights(const AVFrame& frame) {
    switch (frame.colorspace) {
    case AVCOL_SPC_BT709:
        return {0.2126f, 0.0722f};
    case AVCOL_SPC_BT2020_NCL:
    case AVCOL_SPC_BT2020_CL:
        return {0.2627f, 0.0593f};
    case AVCOL_SPC_BT470BG:
    case AVCOL_SPC_SMPTE170M:
        return {0.299f, 0.114f};
    default:
        return frame.height > 576 ? LumaWeights{0.2126f, 0.0722f} : LumaWeights{0.299f, 0.114f};
    }
}

bool is_full_range(const AVFrame& frame) {
    switch (frame.format) {
    case AV_PIX_FMT_YUVJ420P:
    case AV_PIX_FMT_YUVJ422P:
    case AV_PIX_FMT_YUVJ444P:
    case AV_PIX_FMT_YUVJ440P:
        return true;
    default:
        return frame.color_range == AVCOL_RANGE_JPEG;
    }
}

/// Where a sample of chroma lies among those of luma: between two of them, or on the first.
bool is_between_columns(const AVFrame& frame) {
    return frame.chroma_location == AVCHROMA_LOC_CENTER || frame.chroma_location == AVCHROMA_LOC_TOP ||
           frame.chroma_location == AVCHROMA_LOC_BOTTOM;
}
bool is_between_rows(const AVFrame& frame) {
    return frame.chroma_location != AVCHROMA_LOC_TOPLEFT && frame.chroma_location != AVCHROMA_LOC_TOP;
}

/// Two samples and the part of the second one.
struct Between {
    int first, second;
    float part;
};

Between between(int at, int shift, bool centered, int count) {
    if (shift == 0) return {at, at, 0.0f};
    const float scale = 1.0f / static_cast<float>(1 << shift);
    const float place = centered ? (static_cast<float>(at) + 0.5f) * scale - 0.5f : static_cast<float>(at) * scale;
    const float first = std::floor(place);
    return {std::clamp(static_cast<int>(first), 0, count - 1), std::clamp(static_cast<int>(first) + 1, 0, count - 1),
            place - first};
}

std::uint8_t byte_of(float value) { return static_cast<std::uint8_t>(std::clamp(255.0f * value + 0.5f, 0.0f, 255.0f)); }

/// Reads samples of a frame, whatever its format, row by row.
class FrameRows {
public:
    FrameRows(const AVFrame& frame, const AVPixFmtDescriptor& format) : frame_(frame), format_(format) {}

    /// Of component `c`, on [0, 1] of what its bits hold.
    void read(int c, int row, int count, std::vector<float>& result) const {
        std::vector<std::uint16_t> samples(static_cast<std::size_t>(count));
        const bool palette = (format_.flags & AV_PIX_FMT_FLAG_PAL) != 0;
        std::array<const std::uint8_t*, 4> planes{};
        std::copy_n(frame_.data, 4, planes.begin());
        // A palette's entries are 0xAARRGGBB: blue is first in memory.
        av_read_image_line2(samples.data(), planes.data(), frame_.linesize, &format_, 0, row, palette ? 2 - c : c,
                            count, palette ? 1 : 0, sizeof(std::uint16_t));
        const int depth = palette ? 8 : format_.comp[c].depth;
        const float scale = 1.0f / static_cast<float>((1 << depth) - 1);
        result.resize(samples.size());
        std::ranges::transform(samples, result.begin(), [&](std::uint16_t s) { return static_cast<float>(s) * scale; });
    }

private:
    const AVFrame& frame_;
    const AVPixFmtDescriptor& format_;
};

void copy_rgb_row(const FrameRows& rows, bool grey, int y, Image& image) {
    std::vector<float> values;
    for (int c = 0; c < 3; ++c) {
        if (c == 0 || !grey) rows.read(c, y, image.width, values);
        for (int x = 0; x < image.width; ++x)
            image.u8()[3 * (y * image.width + x) + c] = byte_of(values[static_cast<std::size_t>(x)]);
    }
}

class YuvRows {
public:
    YuvRows(const AVFrame& frame, const AVPixFmtDescriptor& format)
        : rows_(frame, format), frame_(frame), format_(format), weights_(luma_weights(frame)),
          columns_(AV_CEIL_RSHIFT(frame.width, format.log2_chroma_w)),
          chroma_rows_(AV_CEIL_RSHIFT(frame.height, format.log2_chroma_h)) {
        const float most = static_cast<float>((1 << format.comp[0].depth) - 1);
        const float unit = static_cast<float>(1 << (format.comp[0].depth - 8)) / most; // of 8 bits
        const bool full = is_full_range(frame);
        black_ = full ? 0.0f : 16.0f * unit;
        luma_ = full ? 1.0f : 1.0f / (219.0f * unit);
        middle_ = 128.0f * unit;
        chroma_ = full ? 1.0f : 1.0f / (224.0f * unit);
    }

    void convert(int y, Image& image) const {
        const Between up = between(y, format_.log2_chroma_h, is_between_rows(frame_), chroma_rows_);
        std::vector<float> luma, blue, red;
        rows_.read(0, y, image.width, luma);
        read_chroma(1, up, blue);
        read_chroma(2, up, red);
        const bool centered = is_between_columns(frame_);
        const float green_weight = 1.0f - weights_.red - weights_.blue;
        std::uint8_t* out = image.u8() + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
        for (int x = 0; x < image.width; ++x, out += 3) {
            const Between across = between(x, format_.log2_chroma_w, centered, columns_);
            const float l = (luma[static_cast<std::size_t>(x)] - black_) * luma_;
            const float b = l + 2.0f * (1.0f - weights_.blue) * chroma(blue, across);
            const float r = l + 2.0f * (1.0f - weights_.red) * chroma(red, across);
            out[0] = byte_of(r);
            out[1] = byte_of((l - weights_.red * r - weights_.blue * b) / green_weight);
            out[2] = byte_of(b);
        }
    }

private:
    void read_chroma(int c, const Between& up, std::vector<float>& result) const {
        rows_.read(c, up.first, columns_, result);
        if (up.part == 0.0f) return;
        std::vector<float> above;
        rows_.read(c, up.second, columns_, above);
        for (std::size_t i = 0; i < result.size(); ++i) result[i] += up.part * (above[i] - result[i]);
    }

    [[nodiscard]] float chroma(const std::vector<float>& row, const Between& across) const {
        const float first = row[static_cast<std::size_t>(across.first)];
        return (first + across.part * (row[static_cast<std::size_t>(across.second)] - first) - middle_) * chroma_;
    }

    FrameRows rows_;
    const AVFrame& frame_;
    const AVPixFmtDescriptor& format_;
    LumaWeights weights_;
    int columns_, chroma_rows_;
    float black_ = 0.0f, luma_ = 1.0f, middle_ = 0.5f, chroma_ = 1.0f;
};

} // namespace

std::optional<Image> video_pixels(const AVFrame& frame, int width, int height) {
    const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
    if (!format || (format->flags & (AV_PIX_FMT_FLAG_HWACCEL | AV_PIX_FMT_FLAG_FLOAT)) != 0) return {};
    if (frame.width != width || frame.height != height) return {};
    Image image = make_image(width, height, 3, PixelType::u8);
    const bool grey = format->nb_components < 3 && (format->flags & AV_PIX_FMT_FLAG_PAL) == 0;
    if (grey || (format->flags & (AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL)) != 0) {
        const FrameRows rows(frame, *format);
        parallel_for(static_cast<std::size_t>(height),
                     [&](std::size_t y) { copy_rgb_row(rows, grey, static_cast<int>(y), image); });
    } else {
        const YuvRows rows(frame, *format);
        parallel_for(static_cast<std::size_t>(height),
                     [&](std::size_t y) { rows.convert(static_cast<int>(y), image); });
    }
    return image;
}

} // namespace hachure::assets
