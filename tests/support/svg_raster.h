#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::test {

/// A path of an SVG file as written by assets::svg_text: M, L, A (half circles) and Z, filled or with a stroke.
struct SvgPath {
    std::string layer; ///< the id of the innermost group
    std::vector<glm::dvec2> points;
    std::vector<glm::dvec2> corners; ///< those that the file says, without what makes arcs round
    bool closed = false, filled = false;
    double width = 0.0, opacity = 1.0;

    /// The middle of the line: of an outline, that between its sides.
    [[nodiscard]] std::vector<glm::dvec2> middle() const {
        if (!filled) return points;
        std::vector<glm::dvec2> result;
        const std::size_t sides = corners.size() / 2 * 2; // an arc at the start ends where the path began
        for (std::size_t i = 0; i < sides / 2; ++i) result.push_back(0.5 * (corners[i] + corners[sides - 1 - i]));
        return result;
    }
};

/// Reads what the house writes, and nothing else: whoever else reads SVG shares no code with it.
inline std::vector<SvgPath> read_svg_paths(std::string_view text) {
    std::vector<SvgPath> paths;
    std::vector<std::string> groups;
    for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;) {
        const std::size_t end = text.find('>', at);
        const std::string_view tag = text.substr(at, end - at);
        at = end;
        const auto value = [&](std::string_view name) {
            const std::size_t i = tag.find(' ' + std::string(name) + "=\"");
            if (i == tag.npos) return std::string();
            const std::size_t from = i + name.size() + 3;
            return std::string(tag.substr(from, tag.find('"', from) - from));
        };
        if (tag.starts_with("<g ")) groups.push_back(value("id"));
        if (tag.starts_with("</g")) groups.pop_back();
        if (!tag.starts_with("<path ")) continue;
        SvgPath path;
        path.layer = groups.empty() ? "" : groups.back();
        path.filled = value("fill") != "none";
        path.width = path.filled ? 0.0 : std::stod(value("stroke-width"));
        const std::string opacity = value(path.filled ? "fill-opacity" : "stroke-opacity");
        path.opacity = opacity.empty() ? 1.0 : std::stod(opacity);
        const std::string data = value("d");
        const char* c = data.c_str();
        const auto number = [&c] {
            char* stop = nullptr;
            const double n = std::strtod(c, &stop);
            if (stop == c) throw std::runtime_error("no number in a path");
            c = stop;
            return n;
        };
        while (*c != 0) {
            const char command = *c++;
            if (command == 'Z') {
                path.closed = true;
            } else if (command == 'M' || command == 'L') {
                const double x = number();
                path.points.emplace_back(x, number());
                path.corners.push_back(path.points.back());
            } else if (command == 'A') {
                for (int i = 0; i < 5; ++i) static_cast<void>(number());
                const glm::dvec2 from = path.points.back();
                const double x = number();
                const glm::dvec2 to(x, number()), middle = 0.5 * (from + to), arm = from - middle;
                path.corners.push_back(to);
                for (int i = 1; i <= 12; ++i) { // clockwise as one sees it
                    const double a = 3.14159265358979 * i / 12;
                    path.points.push_back(middle + std::cos(a) * arm + std::sin(a) * glm::dvec2(-arm.y, arm.x));
                }
            } else {
                throw std::runtime_error("unknown command in a path");
            }
        }
        paths.push_back(path);
    }
    return paths;
}

inline double distance_to_path(const SvgPath& path, glm::dvec2 p) {
    double least = 1e9;
    const std::size_t count = path.points.size();
    for (std::size_t i = 0; i + (path.closed ? 0 : 1) < count; ++i) {
        const glm::dvec2 a = path.points[i], step = path.points[(i + 1) % count] - a;
        const double t = std::clamp(glm::dot(p - a, step) / std::max(glm::dot(step, step), 1e-12), 0.0, 1.0);
        least = std::min(least, glm::distance(p, a + t * step));
    }
    return least;
}

/// How often the outline goes round a place.
inline int winding(const SvgPath& path, glm::dvec2 p) {
    int turns = 0;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const glm::dvec2 a = path.points[i], b = path.points[(i + 1) % path.points.size()];
        const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        if (a.y <= p.y && b.y > p.y && side > 0.0) ++turns;
        if (a.y > p.y && b.y <= p.y && side < 0.0) --turns;
    }
    return turns;
}

/// Opacity of all paths of layers whose id ends so, row by row from the top: 4 x 4 samples a pixel, path over path.
inline std::vector<double> rasterise(const std::vector<SvgPath>& paths, int width, int height,
                                     std::string_view layer = "") {
    std::vector<double> clear(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1.0);
    for (const SvgPath& path : paths) {
        if (!path.layer.ends_with(layer)) continue;
        glm::dvec2 low(1e9), high(-1e9);
        for (const glm::dvec2& p : path.points) {
            low = glm::min(low, p - 0.5 * path.width);
            high = glm::max(high, p + 0.5 * path.width);
        }
        for (int y = std::max(0, static_cast<int>(low.y)); y < std::min(height, static_cast<int>(high.y) + 1); ++y)
            for (int x = std::max(0, static_cast<int>(low.x)); x < std::min(width, static_cast<int>(high.x) + 1); ++x) {
                int inside = 0;
                for (int i = 0; i < 16; ++i) {
                    const glm::dvec2 p(x + (i % 4 + 0.5) / 4.0, y + (i / 4 + 0.5) / 4.0);
                    inside += path.filled ? winding(path, p) != 0 : distance_to_path(path, p) <= 0.5 * path.width;
                }
                clear[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] *=
                    1.0 - path.opacity * inside / 16.0;
            }
    }
    std::ranges::transform(clear, clear.begin(), [](double c) { return 1.0 - c; });
    return clear;
}

} // namespace hachure::test
