// A mechanical part in the four looks of figure 10 of Gooch 1998; README.md beside this file says what it shows.

#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/samples/common/sample_window.h>
#include <hachure/systems/capabilities.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "figure.h"
#include "gallery.h"
#include "part.h"

namespace {

using namespace hachure;

struct Options {
    std::vector<std::string> models; ///< files; none for the sample's own part
    bool gallery = false;
    std::string picture; ///< file; empty for a window
    Canvas size{0, 0};   ///< 0: what suits the cells
};

constexpr int samples = 3; ///< a side, of each pixel of a picture
constexpr float line_width = 1.4f;

/// The models that are shown, and how.
struct Shown {
    explicit Shown(const Options& options) : models{make_part()} {
        for (const std::string& file : options.models) models.push_back(assets::read_model(file));
        if (options.gallery) models.push_back(whitened(models[2]));
    }

    [[nodiscard]] std::vector<Cell> cells(const Options& options) const {
        if (options.gallery) return gallery(models[1], models[2], models[3], models[0]);
        // The pieces of the part have axes; other models bend as they like.
        if (models.size() == 1) return figure_10(models[0], MetalSource::around_axis, leaning());
        return figure_10(models[1], MetalSource::curvature, half_profile());
    }

    std::vector<assets::Model> models; ///< the part first
};

double linear(std::uint8_t encoded) {
    const double s = encoded / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

std::uint8_t encoded(double light) {
    const double s = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * std::min(1.0, s)));
}

/// The mean of `samples` x `samples` pixels, of their light.
assets::Image shrink(const assets::Image& image) {
    std::array<double, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = linear(static_cast<std::uint8_t>(i));
    assets::Image result = assets::make_image(image.width / samples, image.height / samples, 3, assets::PixelType::u8);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            for (int c = 0; c < 3; ++c) {
                double sum = 0.0;
                for (int i = 0; i < samples * samples; ++i)
                    sum += light[image.u8()[((y * samples + i / samples) * image.width + x * samples + i % samples) *
                                                image.channels +
                                            c]];
                result.u8()[(y * result.width + x) * 3 + c] = encoded(sum / (samples * samples));
            }
    return result;
}

int draw_picture(const Options& options) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    const Shown shown(options);
    Figure figure(app, shown.cells(options), line_width * samples);
    figure.arrange({options.size.width * samples, options.size.height * samples});
    renderer.render_frame();
    assets::write_png(options.picture, shrink(renderer.read_picture()));
    return 0;
}

int run_window(const Options& options) {
    samples::SampleWindow window("mechanical", options.size);
    App app;
    register_capabilities(app);
    Renderer renderer(app, window.context());
    const Shown shown(options);
    Figure figure(app, shown.cells(options), line_width);
    Canvas arranged = options.size;
    figure.arrange(arranged);
    while (window.next_frame(app.world())) {
        const samples::Hand& hand = window.hand();
        if (hand.drag != glm::vec2(0.0f)) figure.turn(0.008f * hand.drag.x, 0.008f * hand.drag.y);
        if (const Canvas canvas = app.world().resource<Canvas>(); !(canvas == arranged))
            figure.arrange(arranged = canvas);
        renderer.render_frame();
        renderer.present();
    }
    return 0;
}

int refuse() {
    std::fputs("usage: mechanical [MODEL] [-o PICTURE.png] [--size WIDTHxHEIGHT]\n"
               "       mechanical --gallery CHARACTER STATUE [-o PICTURE.png] [--size WIDTHxHEIGHT]\n",
               stderr);
    return 2;
}

bool read_size(const char* text, Canvas& size) {
    int end = 0;
    return std::sscanf(text, "%dx%d%n", &size.width, &size.height, &end) == 2 && text[end] == '\0' && size.width > 0 &&
           size.height > 0 && size.width <= 5000 && size.height <= 5000;
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "-o" && i + 1 < argc)
            options.picture = argv[++i];
        else if (word == "--size" && i + 1 < argc) {
            if (!read_size(argv[++i], options.size)) return refuse();
        } else if (word == "--gallery")
            options.gallery = true;
        else if (word.starts_with("-"))
            return refuse();
        else
            options.models.emplace_back(word);
    }
    if (options.gallery ? options.models.size() != 2 : options.models.size() > 1) return refuse();
    if (options.size.width == 0) options.size = options.gallery ? Canvas{1200, 1080} : Canvas{1600, 480};
    try {
        return options.picture.empty() ? run_window(options) : draw_picture(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "mechanical: error: %s\n", error.what());
        return 1;
    }
}
