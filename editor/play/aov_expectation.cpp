#include <hachure/editor/play/golden_file.h>
#include <hachure/editor/play/make_expectation.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/picture/compare.h>
#include <hachure/runtime/picture/difference_picture.h>
#include <hachure/runtime/picture/pixels.h>
#include <hachure/runtime/scene/frame_requests.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace hachure::play {
namespace {

constexpr double default_difference = 1e-3, default_share = 1e-3;
constexpr double background = 1e9; // of depth, where nothing is drawn: beyond every scene

/// A buffer as a picture for people: its values between those of `reference` from black to white.
assets::Image visible(const assets::Image& buffer, const assets::Image& reference) {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (std::size_t i = 0; i < picture::pixel_count(reference); ++i)
        for (int c = 0; c < reference.channels; ++c) {
            const double value = picture::channel(reference, i, c);
            if (!(std::abs(value) < background)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    assets::Image result = assets::make_image(buffer.width, buffer.height, 3, assets::PixelType::u8);
    for (std::size_t i = 0; i < picture::pixel_count(buffer); ++i)
        for (int c = 0; c < 3; ++c) {
            const double value = c < buffer.channels    ? picture::channel(buffer, i, c)
                                 : buffer.channels == 1 ? picture::channel(buffer, i, 0)
                                                        : low;
            const double shown = high > low ? (value - low) / (high - low) : 0.0;
            picture::set_channel(result, i, c, shown == shown ? shown : 1.0);
        }
    return result;
}

/// A buffer of a frame is finite and, where one is kept, as it is kept, value by value.
class AovExpectation final : public Expectation {
public:
    AovExpectation(const ExpectationParts& parts)
        : Expectation("aov", parts.source.pointer, parts.frames), name_(parts.object.text("aov")) {
        if (frames().first != frames().last) parts.object.fail("frames", "a buffer is of one frame: it takes frame");
        if (!parts.object.has("picture")) return;
        golden_file_ = parse_picture_path(parts.object, "picture", parts.source.folder, ".exr");
        golden_name_ = parts.object.text("picture");
        mask_file_ = parse_mask(parts.object, parts.source.folder);
        if (const nlohmann::json* gates = parts.object.find("gates")) {
            JsonObject object(parts.source.text, parts.object.pointer("gates"), *gates);
            difference_ = object.number("difference", 0.0, std::numeric_limits<double>::max(), difference_);
            share_ = object.number("share", 0.0, 1.0, share_);
            object.finish();
        }
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::drawn; }
    [[nodiscard]] std::string aov() const override { return name_; }

    void look(PlayedFrame& frame) override {
        actual_ = frame.aov(name_);
        for (const AovInfo& info : frame.world().resource<FrameRequests>().known)
            if (info.name == name_) channel_names_ = info.channel_names;
    }

protected:
    [[nodiscard]] std::string what() const override {
        return golden_name_.empty() ? name_ + " is finite" : name_ + " is as in " + golden_name_;
    }

    void judge(const JudgeContext& context, ExpectationResult& result) override {
        if (!picture::all_finite(actual_)) return fail(frames().first, "a value of " + name_ + " is not finite");
        if (golden_file_.empty()) return;
        const GoldenFile golden =
            read_golden(golden_file_, actual_.width, actual_.height, actual_.channels, assets::PixelType::f32);
        if (context.update) return renew(golden, result);
        if (!golden.image) return fail(frames().first, golden.fault + "; play --update makes it anew");
        compare(*golden.image, result);
        if (!context.evidence.empty()) keep(context, *golden.image, result.picture.emplace());
    }

private:
    void compare(const assets::Image& golden, ExpectationResult& result) {
        picture::CompareOptions options{.step = difference_};
        GoldenFile mask;
        if (!mask_file_.empty()) {
            mask = read_golden(mask_file_, actual_.width, actual_.height, 0, assets::PixelType::u8);
            if (!mask.image) return fail(frames().first, "mask: " + mask.fault);
            options.mask = &*mask.image;
        }
        const picture::BufferDifference d = picture::compare_buffers(golden, actual_, options);
        if (!d.finite) return fail(frames().first, "a value of " + golden_file_.string() + " is not finite");
        result.reason = fmt::format("largest difference {:.4g}, {:.4g} % of pixels beyond {:.4g}", d.max_difference,
                                    100.0 * d.differing_fraction, difference_);
        if (d.differing_fraction > share_)
            fail(frames().first, result.reason + fmt::format(", allowed are {:.4g} %", 100.0 * share_));
    }

    void keep(const JudgeContext& context, const assets::Image& golden, PictureEvidence& evidence) const {
        evidence.golden = context.evidence / (context.stem + "-golden.png");
        evidence.actual = context.evidence / (context.stem + "-actual.png");
        evidence.difference = context.evidence / (context.stem + "-difference.png");
        const assets::Image golden_seen = visible(golden, golden), actual_seen = visible(actual_, golden);
        assets::write_png(evidence.golden, golden_seen);
        assets::write_png(evidence.actual, actual_seen);
        assets::write_png(evidence.difference, picture::difference_picture(golden_seen, actual_seen));
    }

    void renew(const GoldenFile& golden, ExpectationResult& result) {
        if (golden.image && identical(*golden.image, actual_)) return;
        make_folder_of(golden_file_);
        assets::write_exr(golden_file_, actual_, channel_names_);
        result.renewed = true;
        result.reason = "written: " + golden_file_.string();
    }

    std::string name_;
    std::filesystem::path golden_file_;
    std::string golden_name_;
    std::filesystem::path mask_file_;
    double difference_ = default_difference, share_ = default_share;
    assets::Image actual_;
    std::vector<std::string> channel_names_;
};

} // namespace

std::unique_ptr<Expectation> make_aov_expectation(const ExpectationParts& parts) {
    return std::make_unique<AovExpectation>(parts);
}

} // namespace hachure::play
