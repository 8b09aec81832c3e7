#include <hachure/editor/play/golden_file.h>
#include <hachure/editor/play/make_expectation.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/picture/difference_picture.h>
#include <hachure/runtime/picture/gates.h>
#include <hachure/runtime/picture/pixels.h>

#include <limits>

namespace hachure::play {
namespace {

picture::PictureGates parse_gates(JsonObject& parent) {
    picture::PictureGates gates;
    const nlohmann::json* value = parent.find("gates");
    if (!value) return gates;
    JsonObject object(parent.document(), parent.pointer("gates"), *value);
    gates.difference = object.number("difference", 0.0, 255.0, gates.difference);
    gates.share = object.number("share", 0.0, 1.0, gates.share);
    gates.flip_p99 = object.number("flip_p99", 0.0, 1.0, gates.flip_p99);
    gates.lines = object.number("lines", 0.0, std::numeric_limits<double>::max(), gates.lines);
    object.finish();
    return gates;
}

/// A frame looks like a picture that is kept.
class PictureExpectation final : public Expectation {
public:
    PictureExpectation(const ExpectationParts& parts)
        : Expectation("picture", parts.source.pointer, parts.frames),
          golden_file_(parse_picture_path(parts.object, "picture", parts.source.folder, ".png")),
          name_(parts.object.text("picture")), mask_file_(parse_mask(parts.object, parts.source.folder)),
          gates_(parse_gates(parts.object)) {
        if (frames().first != frames().last) parts.object.fail("frames", "a picture is of one frame: it takes frame");
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::drawn; }
    void look(PlayedFrame& frame) override { actual_ = frame.picture(); }

protected:
    [[nodiscard]] std::string what() const override { return "looks like " + name_; }

    void judge(const JudgeContext& context, ExpectationResult& result) override {
        const GoldenFile golden = read_golden(golden_file_, actual_.width, actual_.height, 0, assets::PixelType::u8);
        if (context.update) return renew(golden, result);
        PictureEvidence& evidence = result.picture.emplace();
        keep_picture(context, evidence.actual, "-actual.png", actual_);
        if (!golden.image || golden.image->channels < 3)
            return fail(frames().first, (golden.image ? golden_file_.string() + " has no colour" : golden.fault) +
                                            "; play --update makes it anew");
        evidence.golden = golden_file_;
        compare(*golden.image, evidence, result);
        if (!context.evidence.empty())
            keep_picture(context, evidence.difference, "-difference.png",
                         picture::difference_picture(*golden.image, actual_));
    }

private:
    void compare(const assets::Image& golden, PictureEvidence& evidence, ExpectationResult& result) {
        picture::CompareOptions options{.step = gates_.difference};
        GoldenFile mask;
        if (!mask_file_.empty()) {
            mask = read_golden(mask_file_, actual_.width, actual_.height, 0, assets::PixelType::u8);
            if (!mask.image) return fail(frames().first, "mask: " + mask.fault);
            options.mask = &*mask.image;
        }
        const picture::PictureDifference d = picture::compare_pictures(golden, actual_, options);
        evidence.max_difference = d.max_difference;
        evidence.differing_share = d.differing_fraction;
        evidence.flip_p99 = d.flip_p99;
        evidence.flip_max = d.flip_max;
        evidence.line_distance = d.line_distance;
        result.reason = picture::describe(d, gates_);
        if (const std::string exceeded = picture::exceeded_gates(d, gates_); !exceeded.empty())
            fail(frames().first, exceeded);
    }

    void renew(const GoldenFile& golden, ExpectationResult& result) {
        if (golden.image && identical(*golden.image, actual_)) return;
        make_folder_of(golden_file_);
        assets::write_png(golden_file_, actual_);
        result.renewed = true;
        result.reason = "written: " + golden_file_.string();
    }

    static void keep_picture(const JudgeContext& context, std::filesystem::path& file, const std::string& end,
                             const assets::Image& image) {
        if (context.evidence.empty()) return;
        file = context.evidence / (context.stem + end);
        assets::write_png(file, image);
    }

    std::filesystem::path golden_file_;
    std::string name_;
    std::filesystem::path mask_file_;
    picture::PictureGates gates_;
    assets::Image actual_;
};

} // namespace

std::unique_ptr<Expectation> make_picture_expectation(const ExpectationParts& parts) {
    return std::make_unique<PictureExpectation>(parts);
}

} // namespace hachure::play
