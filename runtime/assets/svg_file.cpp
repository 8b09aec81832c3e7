#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/svg_file.h>
#include <hachure/runtime/assets/svg_path.h>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

namespace hachure::assets {
namespace {

/// Lines whose width varies less are of one width, pixels.
constexpr float same_width = 0.05f;

/// Steps of opacity, where it varies along a line.
constexpr int levels = 12;
constexpr float same_opacity = 0.5f / levels;

/// Fainter ones are not seen.
constexpr float least_opacity = 0.004f;

std::string hex_color(const glm::vec3& linear) {
    const auto encoded = [](float value) {
        const double v = std::clamp(double(value), 0.0, 1.0);
        const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
        return static_cast<int>(std::lround(255.0 * s));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", encoded(linear.x), encoded(linear.y), encoded(linear.z));
}

/// How many bytes the UTF-8 sequence at the beginning of `text` has; 0 where there is none. XML has no place for
/// surrogates and U+FFFE, U+FFFF.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
    unsigned code = lead & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0u) != 0x80u) return 0;
        code = code << 6 | (byte(i) & 0x3fu);
    }
    const bool shortest = code >= (length == 4 ? 0x10000u : length == 3 ? 0x800u : 0x80u);
    const bool allowed = code <= 0x10ffffu && (code < 0xd800u || code > 0xdfffu) && code != 0xfffeu && code != 0xffffu;
    return shortest && allowed ? length : 0;
}

/// As the value of an attribute; what XML can't hold becomes '?'.
std::string escaped(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        const char c = text[0];
        if (length == 0 || (static_cast<unsigned char>(c) < 0x20) || c == 0x7f)
            result += '?';
        else if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

bool is_even(std::span<const SvgPoint> points, float SvgPoint::*field, float tolerance) {
    const auto [least, most] = std::ranges::minmax_element(points, {}, field);
    return (*most).*field - (*least).*field <= tolerance;
}

class Writer {
public:
    std::string text(const SvgDrawing& drawing) {
        out_ = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                           "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                           "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"{0}\" "
                           "height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
                           "<rect id=\"background\" width=\"{0}\" height=\"{1}\" fill=\"{2}\"/>\n",
                           drawing.width, drawing.height, hex_color(drawing.background));
        for (const SvgLayer& layer : drawing.layers) write(layer);
        return std::move(out_) + "</svg>\n";
    }

private:
    template <class... T> void print(fmt::format_string<T...> format, T&&... values) {
        fmt::format_to(std::back_inserter(out_), format, std::forward<T>(values)...);
    }

    void write(const SvgLayer& layer) {
        print("<g id=\"{}\" inkscape:groupmode=\"layer\" inkscape:label=\"{}\">\n", layer.id, escaped(layer.label));
        if (!layer.lines.empty()) {
            const std::string color = hex_color(layer.color);
            for (const SvgLine& line : layer.lines) write(line, color);
        }
        for (const SvgLayer& above : layer.layers) write(above);
        out_ += "</g>\n";
    }

    void write(const SvgLine& line, const std::string& color) {
        const std::span<const SvgPoint> points(line.points);
        if (!is_even(points, &SvgPoint::opacity, same_opacity)) return write_levels(line, color);
        float width = 0.0f, opacity = 0.0f;
        for (const SvgPoint& point : points) {
            width += point.width / static_cast<float>(points.size());
            opacity += point.opacity / static_cast<float>(points.size());
        }
        if (opacity < least_opacity) return;
        if (is_even(points, &SvgPoint::width, same_width))
            print("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linecap=\"round\" "
                  "stroke-linejoin=\"round\"{}/>\n",
                  svg_path(points, line.closed), color, width, with_opacity("stroke", opacity));
        else
            write_outline(points, color, opacity, !line.closed, !line.closed);
    }

    static std::string with_opacity(const char* what, float opacity) {
        return opacity < 0.995f ? fmt::format(" {}-opacity=\"{:.3f}\"", what, opacity) : std::string();
    }

    void write_outline(std::span<const SvgPoint> points, const std::string& color, float opacity, bool round_start,
                       bool round_end) {
        print("<path d=\"{}\" fill=\"{}\"{}/>\n", svg_outline(points, round_start, round_end), color,
              with_opacity("fill", opacity));
    }

    /// A line whose opacity varies: all of it with the least, what is more opaque again with a little more, and so on.
    /// Pieces beside each other would show where they meet, as each is smoothed at its edge for itself.
    void write_levels(const SvgLine& line, const std::string& color) {
        const auto least = std::ranges::min(line.points, {}, &SvgPoint::opacity).opacity;
        const int base = std::clamp(static_cast<int>(least * levels + 0.5f), 0, levels);
        if (base > 0) write_run(line.points, line, color, static_cast<float>(base) / levels);
        for (int level = base + 1; level <= levels; ++level) {
            const float threshold = (static_cast<float>(level) - 0.5f) / levels;
            const float more = 1.0f / static_cast<float>(levels - level + 1); // of what the levels below leave
            std::vector<SvgPoint> run;
            for (std::size_t i = 0; i < line.points.size(); ++i) {
                const SvgPoint& point = line.points[i];
                const bool above = point.opacity >= threshold;
                if (i > 0 && above != (line.points[i - 1].opacity >= threshold)) {
                    const SvgPoint& before = line.points[i - 1];
                    const float t = (threshold - before.opacity) / (point.opacity - before.opacity);
                    run.push_back(
                        {glm::mix(before.place, point.place, t), glm::mix(before.width, point.width, t), threshold});
                    if (!above) {
                        write_run(run, line, color, more);
                        run.clear();
                    }
                }
                if (above) run.push_back(point);
            }
            write_run(run, line, color, more);
        }
    }

    /// A part of a line with one opacity; round only where the line itself ends.
    void write_run(const std::vector<SvgPoint>& run, const SvgLine& line, const std::string& color, float opacity) {
        if (run.size() < 2) return;
        const bool starts = !line.closed && run.front().place == line.points.front().place;
        const bool ends = !line.closed && run.back().place == line.points.back().place;
        write_outline(run, color, opacity, starts, ends);
    }

    std::string out_;
};

} // namespace

std::string svg_text(const SvgDrawing& drawing) { return Writer().text(drawing); }

void write_svg(const std::filesystem::path& file, const SvgDrawing& drawing) {
    const std::string text = svg_text(drawing);
    write_file_atomically(file, std::as_bytes(std::span(text)));
}

bool is_whole_svg(const std::filesystem::path& file, int width, int height) {
    std::ifstream in(file, std::ios::binary);
    std::array<char, 512> begin{};
    in.read(begin.data(), begin.size());
    const std::string_view head(begin.data(), static_cast<std::size_t>(in.gcount()));
    if (head.find(fmt::format(" width=\"{}\" height=\"{}\" viewBox", width, height)) == head.npos) return false;
    constexpr std::string_view closing = "</svg>\n";
    std::array<char, closing.size()> end{};
    in.clear();
    in.seekg(-static_cast<std::streamoff>(closing.size()), std::ios::end);
    in.read(end.data(), end.size());
    return in && std::string_view(end.data(), end.size()) == closing;
}

} // namespace hachure::assets
