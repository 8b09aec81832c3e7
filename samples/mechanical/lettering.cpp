#include "lettering.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using hachure::SurfaceMesh;
using Line = std::vector<glm::vec2>;

constexpr float x_height = 6.0f, gap = 2.1f, pen = 0.38f; ///< grid units: of the letters below, and half of the pen

/// Strokes on a grid where small letters are 6 high: "l x y x y ..." a line, "a cx cy rx ry from to" an arc in degrees.
const std::map<char, std::pair<float, const char*>>& letters() {
    static const std::map<char, std::pair<float, const char*>> table = {
        {' ', {1.6f, ""}},
        {',', {1.0f, "l 0.8 0.4 0 -1.6"}},
        {'(', {2.0f, "a 5.5 4 5.5 6.4 130 230"}},
        {')', {2.0f, "a -3.5 4 5.5 6.4 -50 50"}},
        {'-', {3.0f, "l 0 3 3 3"}},
        {'a', {5.4f, "a 2.7 3 2.7 3 0 360 l 5.4 6 5.4 0"}},
        {'b', {5.4f, "l 0 9.5 0 0 a 2.7 3 2.7 3 0 360"}},
        {'c', {4.6f, "a 2.7 3 2.7 3 48 312"}},
        {'d', {5.4f, "l 5.4 9.5 5.4 0 a 2.7 3 2.7 3 0 360"}},
        {'e', {5.2f, "l 0 3.1 5.3 3.1 a 2.65 3 2.65 3 2 318"}},
        {'f', {3.4f, "a 3.2 7.9 1.8 1.6 80 180 l 1.4 7.9 1.4 0 l 0 6 3.2 6"}},
        {'g', {5.4f, "a 2.7 3 2.7 3 0 360 l 5.4 6 5.4 -0.6 a 2.7 -0.6 2.7 2.4 0 -150"}},
        {'h', {4.8f, "l 0 9.5 0 0 a 2.4 3.5 2.4 2.5 180 0 l 4.8 3.5 4.8 0"}},
        {'i', {0.0f, "l 0 6 0 0 l 0 8.4 0 8.5"}},
        {'k', {4.4f, "l 0 9.5 0 0 l 4 6 0 2.3 l 1.5 3.7 4.4 0"}},
        {'l', {1.3f, "l 0 9.5 0 1.3 a 1.3 1.3 1.3 1.3 180 270"}},
        {'m', {8.0f, "l 0 6 0 0 a 2 3.8 2 2.2 180 0 l 4 3.8 4 0 a 6 3.8 2 2.2 180 0 l 8 3.8 8 0"}},
        {'n', {4.8f, "l 0 6 0 0 a 2.4 3.5 2.4 2.5 180 0 l 4.8 3.5 4.8 0"}},
        {'o', {5.4f, "a 2.7 3 2.7 3 0 360"}},
        {'p', {5.4f, "l 0 6 0 -3.4 a 2.7 3 2.7 3 0 360"}},
        {'r', {3.0f, "l 0 6 0 0 a 2.4 3.5 2.4 2.5 180 62"}},
        {'s', {3.8f, "a 2 4.5 1.75 1.5 35 270 a 1.9 1.5 1.9 1.5 90 -145"}},
        {'t', {3.2f, "l 1.2 8.6 1.2 1.5 a 2.6 1.5 1.4 1.5 180 280 l 0 6 3 6"}},
        {'u', {4.8f, "l 0 6 0 2.5 a 2.4 2.5 2.4 2.5 180 360 l 4.8 6 4.8 0"}},
        {'v', {4.8f, "l 0 6 2.4 0 4.8 6"}},
        {'w', {7.2f, "l 0 6 1.8 0 3.6 6 5.4 0 7.2 6"}},
        {'x', {4.4f, "l 0 6 4.4 0 l 4.4 6 0 0"}},
        {'y', {4.8f, "l 0 6 2.4 0 l 4.8 6 1.6 -3.2"}},
        {'G', {6.2f, "a 3.4 4.75 3.4 4.75 48 360 l 6.8 4.75 3.8 4.75"}},
        {'P', {5.0f, "l 0 0 0 9.5 2.4 9.5 a 2.4 7.1 2.6 2.4 90 -90 l 2.4 4.7 0 4.7"}},
        {'T', {6.4f, "l 0 9.5 6.4 9.5 l 3.2 9.5 3.2 0"}}};
    return table;
}

std::vector<Line> strokes(const char* written) {
    std::vector<Line> lines;
    std::istringstream words(written);
    for (std::string word; words >> word;) {
        if (word == "l") {
            lines.emplace_back();
        } else if (word == "a") {
            glm::vec2 centre, radius;
            float from = 0.0f, to = 0.0f;
            words >> centre.x >> centre.y >> radius.x >> radius.y >> from >> to;
            const int pieces = std::max(2, static_cast<int>(std::abs(to - from) / 7.5f));
            lines.emplace_back();
            for (int i = 0; i <= pieces; ++i) {
                const float angle =
                    glm::radians(from + (to - from) * static_cast<float>(i) / static_cast<float>(pieces));
                lines.back().push_back(centre + radius * glm::vec2(std::cos(angle), std::sin(angle)));
            }
        } else {
            glm::vec2 point(std::stof(word), 0.0f);
            words >> point.y;
            lines.back().push_back(point);
        }
    }
    return lines;
}

void add_triangle(SurfaceMesh& mesh, glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    for (const glm::vec2 p : {a, b, c}) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.emplace_back(p / x_height, 0.0f);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    }
}

/// A straight piece with the round ends of a pen.
void add_piece(SurfaceMesh& mesh, glm::vec2 from, glm::vec2 to) {
    const float direction = std::atan2(to.y - from.y, to.x - from.x);
    std::vector<glm::vec2> outline;
    constexpr int round = 8;
    for (const auto& [end, start] : {std::pair(to, -90.0f), std::pair(from, 90.0f)})
        for (int i = 0; i <= round; ++i) {
            const float angle = direction + glm::radians(start + 180.0f * static_cast<float>(i) / round);
            outline.push_back(end + pen * glm::vec2(std::cos(angle), std::sin(angle)));
        }
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) add_triangle(mesh, outline[0], outline[i], outline[i + 1]);
}

float grid_width(std::string_view text) {
    float width = 0.0f;
    for (const char letter : text) {
        const auto found = letters().find(letter);
        width += (found == letters().end() ? 3.0f : found->second.first) + gap;
    }
    return std::max(0.0f, width - gap);
}

} // namespace

float lettering_width(std::string_view text) { return grid_width(text) / x_height; }

SurfaceMesh lettering(std::string_view text, glm::vec3 color) {
    SurfaceMesh mesh;
    mesh.name = "text";
    float x = -0.5f * grid_width(text);
    for (const char letter : text) {
        const auto found = letters().find(letter);
        if (found != letters().end())
            for (const Line& line : strokes(found->second.second))
                for (std::size_t i = 0; i + 1 < line.size(); ++i)
                    add_piece(mesh, line[i] + glm::vec2(x, 0.0f), line[i + 1] + glm::vec2(x, 0.0f));
        x += (found == letters().end() ? 3.0f : found->second.first) + gap;
    }
    hachure::SurfaceMaterial material;
    material.base_color = glm::vec4(color, 1.0f);
    mesh.submeshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), material}};
    return mesh;
}
