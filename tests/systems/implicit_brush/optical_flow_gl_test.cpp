#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/systems/implicit_brush/optical_flow.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/implicit_brush/wave_picture.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace hachure::test {
namespace {

constexpr int flow_width = 320, flow_height = 240;

struct FlowError {
    double rms = 0.0;     ///< pixels, of what was in the picture before
    double inner = 0.0;   ///< the same, of what is and was 16 pixels from the edges
    double largest = 0.0; ///< of that
};

using ToneChange = std::function<double(double)>;
double as_it_is(double tone) { return tone; }

struct OpticalFlowTest : ::testing::Test {
    void SetUp() override {
        std::string reason;
        gpu::Context* context = GlContexts::use(gpu::Backend::egl, reason);
        if (!context) GTEST_SKIP() << "no EGL context: " << reason;
        renderer = std::make_unique<Renderer>(app, *context);
        render = &app.world().resource_mutable<RenderContext>();
        job = {make({flow_width, flow_height, gpu::Format::r32f}), make({flow_width, flow_height, gpu::Format::r32f}),
               make(OpticalFlowJob::flow_desc(flow_width, flow_height))};
        for (const gpu::TextureDesc& desc : OpticalFlowJob::scratch(flow_width, flow_height))
            scratch.push_back(make(desc));
    }

    std::uint32_t make(const gpu::TextureDesc& desc) { return render->backend->create_texture(desc, "flow"); }

    void upload(std::uint32_t id, const std::function<double(glm::dvec2)>& tone) {
        std::vector<float> tones;
        for (int y = 0; y < flow_height; ++y)
            for (int x = 0; x < flow_width; ++x) tones.push_back(static_cast<float>(tone({x + 0.5, y + 0.5})));
        render->backend->texture(id).upload(std::span<const float>(tones), gpu::RowOrder::bottom_first);
    }

    std::vector<glm::dvec2> flow() {
        job.run(*render, scratch);
        const std::vector<float> values = render->backend->texture(job.to).read_floats(gpu::RowOrder::bottom_first);
        std::vector<glm::dvec2> result;
        for (std::size_t i = 0; i < values.size(); i += 2) result.emplace_back(values[i], values[i + 1]);
        return result;
    }

    /// Of a picture that moves so, and whose tones change so.
    FlowError error(const Origin& origin, const ToneChange& change) {
        upload(job.before, [&](glm::dvec2 p) { return picture.tone(p); });
        upload(job.now, [&](glm::dvec2 p) { return change(picture.tone(origin(p))); });
        const std::vector<glm::dvec2> found = flow();
        FlowError result;
        const auto in_picture = [](glm::dvec2 p, double edge) {
            return p.x > edge && p.y > edge && p.x < flow_width - edge && p.y < flow_height - edge;
        };
        double count = 0.0, inner_count = 0.0;
        for (int y = 0; y < flow_height / 2; ++y)
            for (int x = 0; x < flow_width / 2; ++x) {
                const glm::dvec2 place(2.0 * x + 1.0, 2.0 * y + 1.0), from = origin(place);
                if (!in_picture(from, 0.0)) continue;
                const double off =
                    glm::length(found[static_cast<std::size_t>(y * flow_width / 2 + x)] - (place - from));
                result.rms += off * off;
                count += 1.0;
                if (!in_picture(from, 16.0) || !in_picture(place, 16.0)) continue;
                result.inner += off * off;
                result.largest = std::max(result.largest, off);
                inner_count += 1.0;
            }
        result.rms = std::sqrt(result.rms / count);
        result.inner = std::sqrt(result.inner / inner_count);
        return result;
    }

    void expect(const char* what, const Origin& origin, double inner, double rms, const ToneChange& change = as_it_is) {
        const FlowError found = error(origin, change);
        RecordProperty(what, std::to_string(found.rms) + " rms, " + std::to_string(found.inner) + " inner, " +
                                 std::to_string(found.largest) + " largest of these");
        EXPECT_LT(found.inner, inner) << what;
        EXPECT_LT(found.rms, rms) << what;
    }

    App app;
    std::unique_ptr<Renderer> renderer;
    RenderContext* render = nullptr;
    WavePicture picture;
    OpticalFlowJob job;
    std::vector<std::uint32_t> scratch;
};

/// About the picture's middle.
Origin turned(double degrees, double times) {
    return turned_about({0.5 * flow_width, 0.5 * flow_height}, degrees, times);
}

TEST_F(OpticalFlowTest, IsZeroForAStillPicture) {
    const FlowError found = error(shifted(0, 0), as_it_is);
    EXPECT_LT(found.largest, 1e-3);
}

TEST_F(OpticalFlowTest, FindsShifts) {
    expect("shift_1_2", shifted(1.3, -2.6), 0.15, 0.2);
    expect("shift_8", shifted(-8.0, 3.0), 0.15, 0.2);
    expect("shift_16", shifted(16.0, 0.0), 0.15, 0.2);
    expect("shift_11_11", shifted(-11.3, -11.3), 0.15, 0.2);
}

TEST_F(OpticalFlowTest, FindsTurnsAndZooms) {
    expect("turn_3", turned(3.0, 1.0), 0.15, 0.2);
    expect("turn_6", turned(6.0, 1.0), 0.15, 0.2);
    expect("zoom_in", turned(0.0, 1.06), 0.15, 0.2);
    expect("zoom_out", turned(0.0, 0.94), 0.15, 0.2);
    expect("both", turned(2.0, 1.03), 0.15, 0.2);
}

TEST_F(OpticalFlowTest, DoesNotTakeAFlashForMotion) {
    expect("flash", shifted(3.0, 1.0), 0.15, 0.2, [](double tone) { return tone + 0.2; });
}

/// Half the light, coded as sRGB: about .73 of the tone.
TEST_F(OpticalFlowTest, DoesNotTakeAJumpOfExposureForMotion) {
    const auto darker = [](double tone) { return 0.73 * tone; };
    expect("exposure_still", shifted(0.0, 0.0), 0.15, 0.2, darker);
    expect("exposure", shifted(3.0, 1.0), 0.15, 0.2, darker);
}

/// Where there is nothing to see it is what it is around, and a number.
TEST_F(OpticalFlowTest, IsAtRestWhereThereIsNothing) {
    upload(job.before, [](glm::dvec2) { return 0.5; });
    upload(job.now, [](glm::dvec2 p) { return p.x < 160.0 ? 0.5 : 0.9; });
    for (const glm::dvec2& motion : flow()) EXPECT_LT(glm::length(motion), 64.0);
    upload(job.now, [](glm::dvec2) { return 0.9; });
    for (const glm::dvec2& motion : flow()) EXPECT_LT(glm::length(motion), 1e-3);
}

TEST_F(OpticalFlowTest, FollowsWhatMovesBeforeWhatStands) {
    const auto before = [&](glm::dvec2 p) { return picture.tone(p); };
    const auto inside = [](glm::dvec2 p) { return glm::length(p - glm::dvec2(160.0, 120.0)) < 60.0; };
    upload(job.before, [&](glm::dvec2 p) {
        return inside(p + glm::dvec2(5.0, 2.0)) ? before(0.8 * glm::dvec2(p.y, p.x)) : before(p);
    });
    upload(job.now,
           [&](glm::dvec2 p) { return inside(p) ? before(0.8 * glm::dvec2(p.y - 2.0, p.x - 5.0)) : before(p); });
    const std::vector<glm::dvec2> found = flow();
    double moving = 0.0, standing = 0.0, moving_count = 0.0, standing_count = 0.0;
    for (int y = 0; y < flow_height / 2; ++y)
        for (int x = 0; x < flow_width / 2; ++x) {
            const glm::dvec2 p(2.0 * x + 1.0, 2.0 * y + 1.0), flow_here = found[static_cast<std::size_t>(y * 160 + x)];
            const double off = glm::length(p - glm::dvec2(160.0, 120.0));
            if (off < 40.0) moving += glm::length(flow_here - glm::dvec2(5, 2)), moving_count += 1.0;
            if (off > 85.0) standing += glm::length(flow_here), standing_count += 1.0;
        }
    EXPECT_LT(moving / moving_count, 0.5);
    EXPECT_LT(standing / standing_count, 0.2);
}

} // namespace
} // namespace hachure::test
