#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/film_writers.h>
#include <hachure/runtime/assets/gif_lzw.h>
#include <hachure/runtime/assets/gif_palette.h>

#include <algorithm>
#include <bit>
#include <string_view>

namespace hachure::assets {
namespace {

constexpr int max_side = 65535;

/// Part of the picture, pixels.
struct Rectangle {
    int left = 0, top = 0, width = 0, height = 0;
};

/// GIF89a. A frame holds the rectangle of what changed; pixels in it that did not change are left as they are, so what
/// stands still does not flicker when the colours of a frame are chosen anew.
class GifWriter final : public FrameSequenceWriter {
public:
    GifWriter(const std::filesystem::path& file, FrameRate rate) : file_(file), rate_(rate) {
        HACHURE_ASSERT(rate.frames <= std::int64_t{max_gif_rate} * rate.seconds,
                       "a GIF shows at most 50 frames a second");
    }

    void write(std::int64_t, const Image& image) override {
        HACHURE_ASSERT(image.type == PixelType::u8 && image.channels >= 3, "a film is written from 8-bit RGB images");
        bytes_.clear();
        const bool first = frames_ == 0;
        if (first) begin(image);
        HACHURE_ASSERT(image.width == width_ && image.height == height_, "a film's frames have one size");
        pack(image);
        put_frame(first ? Rectangle{0, 0, width_, height_} : changed_part(), first);
        shown_.swap(pixels_);
        ++frames_;
        file_.write(bytes_);
    }

    void finish() override {
        HACHURE_ASSERT(frames_ > 0, "a film has a frame");
        file_.write(std::as_bytes(std::span(";", 1)));
        file_.commit();
    }

private:
    void put(std::uint32_t byte) { bytes_.push_back(static_cast<std::byte>(byte)); }
    void put_short(std::int64_t value) {
        put(static_cast<std::uint32_t>(value & 0xff));
        put(static_cast<std::uint32_t>(value >> 8 & 0xff));
    }
    void put_text(std::string_view text) {
        for (const char c : text) put(static_cast<unsigned char>(c));
    }

    void begin(const Image& image) {
        HACHURE_ASSERT(image.width <= max_side && image.height <= max_side, "a GIF counts pixels with 16 bits");
        width_ = image.width;
        height_ = image.height;
        put_text("GIF89a");
        put_short(width_);
        put_short(height_);
        put(0x70); // 8 bits a channel, no colours for all frames
        put(0);
        put(0);
        put_text("\x21\xff\x0bNETSCAPE2.0\x03\x01"); // repeats,
        put_short(0);                                // for ever
        put(0);
    }

    void pack(const Image& image) {
        pixels_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        const std::uint8_t* from = image.u8();
        for (PackedColor& pixel : pixels_) {
            pixel = static_cast<PackedColor>(from[0] << 16 | from[1] << 8 | from[2]);
            from += image.channels;
        }
    }

    [[nodiscard]] std::span<const PackedColor> row(const std::vector<PackedColor>& pixels, int y) const {
        return std::span(pixels).subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_),
                                         static_cast<std::size_t>(width_));
    }

    /// The smallest rectangle around what changed; one pixel when nothing did.
    [[nodiscard]] Rectangle changed_part() const {
        int left = width_, right = -1, top = -1, bottom = -1;
        for (int y = 0; y < height_; ++y) {
            const std::span<const PackedColor> now = row(pixels_, y), before = row(shown_, y);
            const auto first = std::mismatch(now.begin(), now.end(), before.begin()).first;
            if (first == now.end()) continue;
            const auto last = std::mismatch(now.rbegin(), now.rend(), before.rbegin()).first;
            left = std::min(left, static_cast<int>(first - now.begin()));
            right = std::max(right, static_cast<int>(last.base() - now.begin()) - 1);
            if (top < 0) top = y;
            bottom = y;
        }
        return top < 0 ? Rectangle{0, 0, 1, 1} : Rectangle{left, top, right - left + 1, bottom - top + 1};
    }

    /// Calls `visit(colour, changed)` for the pixels of the rectangle, row by row.
    template <class Visit> void each_pixel(const Rectangle& part, bool all, Visit visit) const {
        for (int y = part.top; y < part.top + part.height; ++y)
            for (int x = part.left; x < part.left + part.width; ++x) {
                const std::size_t at =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
                visit(pixels_[at], all || pixels_[at] != shown_[at]);
            }
    }

    void put_frame(const Rectangle& part, bool all) {
        changed_.clear();
        each_pixel(part, all, [this](PackedColor color, bool changed) {
            if (changed) changed_.push_back(color);
        });
        reduction_.choose(changed_);
        const std::span<const PackedColor> colors = reduction_.colors();
        const auto unchanged = static_cast<std::uint8_t>(colors.size()); // the index behind the colours
        const int bits = std::max(2, static_cast<int>(std::bit_width(colors.size())));
        indices_.clear();
        each_pixel(part, all, [&](PackedColor color, bool changed) {
            indices_.push_back(changed ? reduction_.index_of(color) : unchanged);
        });
        put_control(unchanged);
        put_description(part, bits);
        for (std::size_t i = 0; i < std::size_t{1} << bits; ++i) {
            const PackedColor color = i < colors.size() ? colors[i] : 0;
            put(color >> 16);
            put(color >> 8 & 0xffu);
            put(color & 0xffu);
        }
        compressor_.compress(indices_, bits, bytes_);
    }

    /// Hundredths of a second from the start to when frame `number` begins, rounded, so that errors don't add up.
    [[nodiscard]] std::int64_t begins(std::int64_t number) const {
        return (200 * number * rate_.seconds + rate_.frames) / (2 * std::int64_t{rate_.frames});
    }

    void put_control(std::uint8_t transparent) {
        put_text("\x21\xf9\x04");
        put(1u << 2 | 1u); // leave it in place for the next one; has a transparent index
        put_short(begins(frames_ + 1) - begins(frames_));
        put(transparent);
        put(0);
    }

    void put_description(const Rectangle& part, int bits) {
        put_text(",");
        put_short(part.left);
        put_short(part.top);
        put_short(part.width);
        put_short(part.height);
        put(0x80u | static_cast<std::uint32_t>(bits - 1)); // has colours of its own, 2^bits of them
    }

    AtomicFile file_;
    FrameRate rate_;
    int width_ = 0, height_ = 0;
    std::int64_t frames_ = 0;
    ColorReduction reduction_;
    GifCompressor compressor_;
    std::vector<PackedColor> pixels_, shown_, changed_;
    std::vector<std::uint8_t> indices_;
    std::vector<std::byte> bytes_;
};

} // namespace

std::unique_ptr<FrameSequenceWriter> make_gif_writer(const std::filesystem::path& file, FrameRate rate) {
    return std::make_unique<GifWriter>(file, rate);
}

} // namespace hachure::assets
