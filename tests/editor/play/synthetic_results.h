#pragma once

#include <hachure/editor/play/play_result.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/support/temp_folder.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

// Results of playback tests that nobody played, with pictures, for tests of the report.
namespace hachure::test {

/// A ball in cool and warm tones with an outline, somewhere along its way: `at` in [0, 1].
inline assets::Image ball(double at, int width = 320, int height = 240, double outline = 2.0) {
    assets::Image image = assets::make_image(width, height, 3, assets::PixelType::u8);
    const double radius = 0.28 * height, cx = (0.25 + 0.5 * at) * width,
                 cy = (0.5 - 0.12 * std::sin(3.14 * at)) * height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double dx = (x - cx) / radius, dy = (y - cy) / radius, distance = std::hypot(dx, dy);
            const double tone = 0.5 + 0.5 * std::clamp(-0.6 * dx - 0.7 * dy, -1.0, 1.0);
            double color[3] = {244, 242, 238};
            if (distance < 1.0)
                for (int c = 0; c < 3; ++c)
                    color[c] = tone * (c == 0   ? 236
                                       : c == 1 ? 205
                                                : 120) +
                               (1 - tone) * (c == 0   ? 70
                                             : c == 1 ? 88
                                                      : 160);
            if (std::abs(distance - 1.0) * radius < outline) color[0] = color[1] = color[2] = 30;
            for (int c = 0; c < 3; ++c) image.u8()[3 * (y * width + x) + c] = static_cast<std::uint8_t>(color[c]);
        }
    return image;
}

/// How far two pictures are apart, brighter where more.
inline assets::Image difference(const assets::Image& a, const assets::Image& b) {
    assets::Image image = a;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        image.u8()[i] = static_cast<std::uint8_t>(std::abs(int{a.u8()[i]} - int{b.u8()[i]}));
    return image;
}

inline std::filesystem::path picture(const TempFolder& folder, const std::string& name, const assets::Image& image) {
    assets::write_png(folder / name, image);
    return folder / name;
}

/// Values around `level` with a bump of height `bump` after two thirds.
inline play::Curve wave(const std::string& name, const std::string& unit, double level, double bump, int frames = 90) {
    play::Curve curve{.name = name, .unit = unit, .first_frame = 0};
    for (int i = 0; i < frames; ++i) {
        const double x = (i - 0.68 * frames) / 4.0;
        curve.values.push_back(level * (1.0 + 0.08 * std::sin(0.9 * i) + 0.05 * std::cos(2.3 * i)) +
                               bump * std::exp(-x * x));
    }
    return curve;
}

inline play::ExpectationResult picture_expectation(const TempFolder& folder, bool passed) {
    const assets::Image golden = ball(0.35), actual = passed ? golden : ball(0.37, 320, 240, 1.2);
    const std::string which = passed ? "good" : "bad";
    play::PictureEvidence evidence{picture(folder, which + "-golden.png", golden),
                                   picture(folder, which + "-actual.png", actual),
                                   picture(folder, which + "-difference.png", difference(golden, actual))};
    if (!passed) {
        evidence.max_difference = 214;
        evidence.differing_share = 0.0231;
        evidence.flip_p99 = 0.214;
        evidence.flip_max = 0.71;
        evidence.line_distance = 6.4;
    }
    return {.kind = "picture",
            .what = "frame 30 looks like golden/fox_run_30.png",
            .pointer = "/expect/0",
            .passed = passed,
            .reason =
                passed ? "at most 0/255 apart" : "FLIP p99 is 0.214, at most 0.05; lines are 6.4 px apart, at most 2",
            .first_frame = 30,
            .last_frame = 30,
            .picture = evidence};
}

inline play::ExpectationResult flicker_expectation(const TempFolder& folder) {
    play::ExpectationResult result{.kind = "popping",
                                   .what = "frames 20 to 31 do not pop",
                                   .pointer = "/expect/3",
                                   .reason = "frame 26 changes by 31/255 more than its neighbours, at most 8",
                                   .first_frame = 20,
                                   .last_frame = 31};
    play::Curve curve = wave("popping", "255ths", 3.0, 0.0, 12);
    curve.first_frame = 20;
    curve.at_most = 8.0;
    curve.values[6] = 31.0;
    curve.values[7] = 12.5;
    result.curves = {curve};
    for (int i = 0; i < 12; ++i)
        result.frames.push_back(
            picture(folder, "frame" + std::to_string(i) + ".png", ball(0.3 + 0.02 * i, 320, 240, i == 6 ? 5.0 : 2.0)));
    return result;
}

/// Everything that the report can show.
inline play::PlayResult failing_result(const TempFolder& folder) {
    play::PlayResult result{.file = "tests/playback/fox_run.play.json",
                            .doc = "The fox runs through the clearing while the light turns once around it.",
                            .seconds = 12.43,
                            .frames = 90,
                            .width = 320,
                            .height = 240,
                            .renderer = "llvmpipe (LLVM 15.0.6, 256 bits)"};
    result.log = {"hachure: warning: fox.glb: image 2 is not used",
                  "hachure: warning: fox.lua:14: wind is nil, taken as 0"};
    result.expectations = {picture_expectation(folder, false)};
    play::ExpectationResult field{.kind = "field",
                                  .what = "frames 0 to 89: Fox/transform.translation.y is 0 to 2",
                                  .pointer = "/expect/1",
                                  .reason = "frame 58 is 2.31 m, at most 2",
                                  .last_frame = 89};
    field.curves = {wave("Fox/transform.translation.y", "m", 0.8, 1.55)};
    field.curves[0].at_least = 0.0;
    field.curves[0].at_most = 2.0;
    result.expectations.push_back(field);
    result.expectations.push_back({.kind = "count",
                                   .what = "frame 5 has 3 surfaces",
                                   .pointer = "/expect/2",
                                   .passed = true,
                                   .reason = "3",
                                   .first_frame = 5,
                                   .last_frame = 5});
    result.expectations.push_back(flicker_expectation(folder));
    result.passes = {{"gooch", 88, 2, 0, 412.4, 0.0},
                     {"edge_lines", 61, 29, 0, 220.13, 0.0},
                     {"overlay", 61, 29, 0, 31.7, 0.0},
                     {"velocity", 0, 0, 90, 0.0, 0.0}};
    for (int i = 0; i < 12; ++i)
        result.strip.push_back(
            {8 * i, picture(folder, "strip" + std::to_string(i) + ".png", ball(i / 11.0, 160, 120, 1.0))});
    result.curves = {wave("frame", "ms", 11.2, 4.0), wave("deform", "ms", 2.1, 0.6)};
    result.replay = "hachure play tests/playback/fox_run.play.json --from 30";
    return result;
}

inline play::PlayResult passing_result(const TempFolder& folder, const std::string& name, const std::string& doc) {
    play::PlayResult result{.file = "tests/playback/" + name + ".play.json",
                            .doc = doc,
                            .passed = true,
                            .seconds = 0.84,
                            .frames = 30,
                            .width = 320,
                            .height = 240,
                            .renderer = "llvmpipe"};
    result.expectations = {picture_expectation(folder, true)};
    result.curves = {wave("frame", "ms", 4.0, 0.5, 30)};
    result.passes = {{"gooch", 30, 0, 0, 40.0, 12.0}};
    result.replay = "hachure play tests/playback/" + name + ".play.json";
    return result;
}

/// As a person might see them; those that failed are not the first.
inline std::vector<play::PlayResult> synthetic_results(const TempFolder& folder) {
    std::vector<play::PlayResult> results{
        passing_result(folder, "bunny_turntable", "A bunny turns once; its lines keep to its silhouette."),
        failing_result(folder),
        passing_result(folder, "clip_fades", "Walking fades into running without a jump."),
        passing_result(folder, "door_events", "The door opens when it is told to, and says so."),
        {.file = "tests/playback/broken_script.play.json",
         .doc = "A script that stumbles.",
         .error = "fox.lua: attempt to index a nil value (global 'wind') (line 14)",
         .seconds = 0.31,
         .frames = 3,
         .log = {"stack traceback:", "\tfox.lua:14: in function 'update'"},
         .replay = "hachure play tests/playback/broken_script.play.json"}};
    results[3].expectations[0].renewed = true;
    return results;
}

} // namespace hachure::test
