#include "solids.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr double whole_turn = 2.0 * glm::pi<double>();

/// Radians around a centre in the plane of y, from 0 to a whole turn.
double angle_around(const glm::dvec3& point, const glm::dvec3& centre) {
    const double angle = std::atan2(point.z - centre.z, point.x - centre.x);
    return angle < -1e-9 ? angle + whole_turn : angle;
}

/// Rotated so that it begins with the point of the smallest angle, and turned so that angles grow.
Loop in_order(Loop loop, const glm::dvec3& centre) {
    std::ranges::sort(loop, {}, [&](const glm::dvec3& p) { return angle_around(p, centre); });
    return loop;
}

} // namespace

glm::dvec3 polar(double radius, double height, double k) {
    const double whole = k - segments * std::floor(k / segments); // the seam's two sides in the same bits
    const double angle = whole_turn * whole / segments;
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

Profile arc(glm::dvec2 centre, double radius, double begin, double end, int pieces) {
    Profile points;
    for (int i = 0; i <= pieces; ++i) {
        const double angle = begin + (end - begin) * i / pieces;
        points.push_back(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

Loop circle(double distance, double k, double radius, double height, int points) {
    const glm::dvec3 centre = polar(distance, height, k);
    Loop loop;
    for (int i = 0; i < points; ++i) loop.push_back(centre + polar(radius, 0.0, double(segments) * i / points));
    return loop;
}

Loop hexagon(double radius, double height) {
    Loop loop;
    for (int i = 0; i < 6; ++i) loop.push_back(polar(radius, height, segments / 6 * i));
    return loop;
}

void Solid::triangle(const glm::dvec3* points, const glm::dvec3* normals) {
    const glm::dvec3 across = glm::cross(points[1] - points[0], points[2] - points[0]);
    if (glm::length(across) < 1e-12) return;
    const bool turned = glm::dot(across, normals[0] + normals[1] + normals[2]) < 0.0;
    for (const int i : {0, turned ? 2 : 1, turned ? 1 : 2}) {
        made_.indices.push_back(static_cast<std::uint32_t>(made_.positions.size()));
        made_.positions.emplace_back(points[i]);
        made_.normals.emplace_back(glm::normalize(normals[i]));
    }
}

void Solid::quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                 const glm::dvec3& na, const glm::dvec3& nb, const glm::dvec3& nc, const glm::dvec3& nd) {
    const glm::dvec3 points[] = {a, b, c, a, c, d}, normals[] = {na, nb, nc, na, nc, nd};
    triangle(points, normals);
    triangle(points + 3, normals + 3);
}

void Solid::turn_line(glm::dvec2 from, glm::dvec2 to, glm::dvec2 outside) {
    glm::dvec2 normal = glm::normalize(glm::dvec2(to.y - from.y, from.x - to.x));
    if (glm::dot(normal, outside) < 0.0) normal = -normal;
    for (int k = 0; k < segments; ++k) {
        const glm::dvec3 n = polar(normal.x, normal.y, k), m = polar(normal.x, normal.y, k + 1);
        quad(polar(from.x, from.y, k), polar(from.x, from.y, k + 1), polar(to.x, to.y, k + 1), polar(to.x, to.y, k), n,
             m, m, n);
    }
}

void Solid::turn_arc(glm::dvec2 centre, double radius, double begin, double end, double sign) {
    const Profile points = arc(centre, radius, begin, end);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::dvec2 a = points[i], b = points[i + 1];
        const glm::dvec2 na = sign * (a - centre), nb = sign * (b - centre);
        for (int k = 0; k < segments; ++k)
            quad(polar(a.x, a.y, k), polar(a.x, a.y, k + 1), polar(b.x, b.y, k + 1), polar(b.x, b.y, k),
                 polar(na.x, na.y, k), polar(na.x, na.y, k + 1), polar(nb.x, nb.y, k + 1), polar(nb.x, nb.y, k));
    }
}

void Solid::face(const Loop& outer, const Loop& inner, glm::dvec3 centre, glm::dvec3 normal) {
    const glm::dvec3 normals[] = {normal, normal, normal};
    const Loop a = in_order(outer, centre), b = inner.empty() ? Loop{centre} : in_order(inner, centre);
    const auto next_angle = [&](const Loop& loop, std::size_t at) {
        return at + 1 < loop.size() ? angle_around(loop[at + 1], centre) : whole_turn + angle_around(loop[0], centre);
    };
    // Both loops are walked by angle; the one whose next point comes first makes the triangle.
    std::size_t i = 0, j = 0;
    const bool fan = inner.empty();
    while (i < a.size() || (!fan && j < b.size())) {
        const bool outer_steps = fan || j >= b.size() || (i < a.size() && next_angle(a, i) <= next_angle(b, j));
        const glm::dvec3 &p = a[i % a.size()], &q = b[j % b.size()];
        const glm::dvec3 points[] = {p, q, outer_steps ? a[(i + 1) % a.size()] : b[(j + 1) % b.size()]};
        triangle(points, normals);
        ++(outer_steps ? i : j);
    }
}

void Solid::wall(const Loop& low, const Loop& high, glm::dvec3 inside, double sign) {
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t j = (i + 1) % low.size();
        glm::dvec3 normal = glm::normalize(glm::cross(low[j] - low[i], high[i] - low[i]));
        if (sign * glm::dot(normal, 0.5 * (low[i] + high[j]) - inside) < 0.0) normal = -normal;
        quad(low[i], low[j], high[j], high[i], normal, normal, normal, normal);
    }
}

void Solid::smooth_wall(const Loop& low, const Loop& high, const std::vector<glm::dvec3>& normals) {
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t j = (i + 1) % low.size();
        quad(low[i], low[j], high[j], high[i], normals[i], normals[j], normals[j], normals[i]);
    }
}

void Solid::hole(const Loop& low, const Loop& high, glm::dvec3 centre) {
    std::vector<glm::dvec3> normals;
    for (const glm::dvec3& p : low) normals.push_back(glm::dvec3(centre.x - p.x, 0.0, centre.z - p.z));
    smooth_wall(low, high, normals);
}

void Solid::sheet(int rows, const std::function<glm::dvec3(double, double)>& at) {
    constexpr double h = 1e-3;
    const auto normal = [&](double row, double k) {
        const double before = std::max(0.0, row - h), after = std::min(double(rows), row + h);
        return glm::normalize(glm::cross(at(after, k) - at(before, k), at(row, k + h) - at(row, k - h)));
    };
    for (int row = 0; row < rows; ++row)
        for (int k = 0; k < segments; ++k)
            quad(at(row, k), at(row, k + 1), at(row + 1, k + 1), at(row + 1, k), normal(row, k), normal(row, k + 1),
                 normal(row + 1, k + 1), normal(row + 1, k));
}

void Solid::holed_face(double inner, double outer, double height, double up, int count, double distance, double radius,
                       int first) {
    const int sector = segments / count;
    for (int i = 0; i < count; ++i) {
        const int middle = first + i * sector;
        Loop border;
        for (int k = middle - sector / 2; k <= middle + sector / 2; ++k) {
            border.push_back(polar(outer, height, k));
            border.push_back(polar(inner, height, k));
        }
        face(border, circle(distance, middle, radius, height, 36), polar(distance, height, middle), {0.0, up, 0.0});
    }
}

hachure::assets::Primitive Solid::finish(int material) {
    made_.material = material;
    return std::move(made_);
}
