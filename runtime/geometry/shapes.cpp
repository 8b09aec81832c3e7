#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/shapes.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace hachure::geometry {
namespace {

constexpr double tau = 2.0 * std::numbers::pi;

/// On the unit circle in xz, such that growing angles run counter-clockwise seen from +Y.
glm::dvec3 around_y(double turns) { return {std::cos(tau * turns), 0.0, -std::sin(tau * turns)}; }

std::uint32_t add(Shape& shape, const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& uv) {
    shape.positions.emplace_back(position);
    shape.normals.emplace_back(glm::normalize(normal));
    shape.texcoords.emplace_back(uv);
    return static_cast<std::uint32_t>(shape.positions.size() - 1);
}

void triangle(Shape& shape, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    shape.indices.insert(shape.indices.end(), {a, b, c});
}

/// A quad with corners in order, cut from `a` to `c`.
void quad(Shape& shape, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangle(shape, a, b, c);
    triangle(shape, a, c, d);
}

/// A disc at `height`, facing along +Y or -Y.
void add_disc(Shape& shape, double radius, double height, double facing, std::uint32_t slices) {
    const glm::dvec3 normal(0.0, facing, 0.0);
    const std::uint32_t centre = add(shape, {0.0, height, 0.0}, normal, {0.5, 0.5});
    for (std::uint32_t i = 0; i < slices; ++i) {
        // The same angles as on the wall, bit for bit, so that the rim is closed; seen from below they fall.
        const std::uint32_t step = facing > 0.0 ? i : (slices - i) % slices;
        const glm::dvec3 p = around_y(static_cast<double>(step) / slices);
        add(shape, radius * p + glm::dvec3(0.0, height, 0.0), normal, {0.5 + 0.5 * p.x, 0.5 - 0.5 * facing * p.z});
        triangle(shape, centre, centre + 1 + i, centre + 1 + (i + 1) % slices);
    }
}

/// A square with `cells` quads a side; `u` x `v` is its normal.
void add_square(Shape& shape, const glm::dvec3& centre, const glm::dvec3& u, const glm::dvec3& v, std::uint32_t cells) {
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const double s = static_cast<double>(i) / cells, t = static_cast<double>(j) / cells;
            add(shape, centre + (s - 0.5) * u + (t - 0.5) * v, glm::cross(u, v), {s, t});
        }
    const std::uint32_t row = cells + 1;
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = first + j * row + i;
            quad(shape, a, a + 1, a + row + 1, a + row);
        }
}

/// The vertex of a torus at fractions of a turn around the axis and across the tube.
std::uint32_t add_torus_vertex(Shape& shape, double major, double minor, double around, double across) {
    const glm::dvec3 out = around_y(around);
    const glm::dvec3 normal = std::cos(tau * across) * out + glm::dvec3(0.0, std::sin(tau * across), 0.0);
    return add(shape, major * out + minor * normal, normal, {around, across});
}

bool faces_front(const Shape& shape, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::dvec3 p(shape.positions[a]), q(shape.positions[b]), r(shape.positions[c]);
    return glm::dot(glm::cross(q - p, r - p), glm::dvec3(shape.normals[a])) > 0.0;
}

/// Whether both triangles of the quad face the front when it is cut from `a` to `c`.
bool is_cut_by(const Shape& shape, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    return faces_front(shape, a, b, c) && faces_front(shape, a, c, d);
}

/// Uniform in [-1, 1), from a counter: any vertex can be computed on its own (splitmix64).
double noise(std::uint32_t seed, std::uint32_t index, std::uint32_t purpose) {
    std::uint64_t x = (static_cast<std::uint64_t>(seed) << 34) + (static_cast<std::uint64_t>(index) << 2) + purpose;
    x = (x + 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 30)) * 0x94d049bb133111ebu;
    x = (x ^ (x >> 27)) * 0xbf58476d1ce4e5b9u;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-52 - 1.0;
}

} // namespace

Shape uv_sphere(double radius, std::uint32_t slices, std::uint32_t stacks) {
    HACHURE_ASSERT(slices >= 3 && stacks >= 2, "a sphere has at least 3 slices and 2 stacks");
    Shape shape;
    for (std::uint32_t j = 0; j <= stacks; ++j)
        for (std::uint32_t i = 0; i <= slices; ++i) {
            const double u = static_cast<double>(i) / slices, v = static_cast<double>(j) / stacks;
            // sin(pi) is not quite 0: at the poles all vertices must be at one place.
            const double ring = j == 0 || j == stacks ? 0.0 : std::sin(0.5 * tau * v);
            const glm::dvec3 n = ring * around_y(u == 1.0 ? 0.0 : u) - glm::dvec3(0.0, std::cos(0.5 * tau * v), 0.0);
            add(shape, radius * n, n, {u, v});
        }
    const std::uint32_t row = slices + 1;
    for (std::uint32_t j = 0; j < stacks; ++j)
        for (std::uint32_t i = 0; i < slices; ++i) {
            const std::uint32_t a = j * row + i;
            if (j > 0) triangle(shape, a, a + 1, a + row);
            if (j + 1 < stacks) triangle(shape, a + 1, a + row + 1, a + row);
        }
    return shape;
}

Shape torus(double major, double minor, std::uint32_t around, std::uint32_t across) {
    HACHURE_ASSERT(around >= 3 && across >= 3 && major > minor, "a torus is a ring of at least 3 x 3 cells");
    Shape shape;
    for (std::uint32_t i = 0; i <= around; ++i)
        for (std::uint32_t j = 0; j <= across; ++j) {
            add_torus_vertex(shape, major, minor, i == around ? 0.0 : static_cast<double>(i) / around,
                             j == across ? 0.0 : static_cast<double>(j) / across);
            shape.texcoords.back() = {static_cast<float>(i) / static_cast<float>(around),
                                      static_cast<float>(j) / static_cast<float>(across)};
        }
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < across; ++j) {
            const std::uint32_t a = i * (across + 1) + j, b = a + across + 1;
            quad(shape, a, b, b + 1, a + 1);
        }
    return shape;
}

Shape irregular_torus(double major, double minor, std::uint32_t around, std::uint32_t across, double jitter,
                      std::uint32_t seed) {
    HACHURE_ASSERT(around >= 3 && across >= 3 && major > minor, "a torus is a ring of at least 3 x 3 cells");
    HACHURE_ASSERT(jitter >= 0.0 && jitter <= 0.45, "cells must not fold over");
    Shape shape;
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < across; ++j) {
            const std::uint32_t index = i * across + j;
            add_torus_vertex(shape, major, minor, (i + jitter * noise(seed, index, 0)) / around,
                             (j + jitter * noise(seed, index, 1)) / across);
        }
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < across; ++j) {
            const std::uint32_t k = (i + 1) % around, l = (j + 1) % across;
            const std::uint32_t a = i * across + j, b = k * across + j, c = k * across + l, d = i * across + l;
            // A large jitter makes some cells concave, and then only one of the diagonals lies inside.
            const bool other = noise(seed, a, 2) < 0.0;
            const bool from_a = other ? !is_cut_by(shape, b, c, d, a) : is_cut_by(shape, a, b, c, d);
            if (from_a)
                quad(shape, a, b, c, d);
            else
                quad(shape, b, c, d, a);
        }
    return shape;
}

Shape cylinder(double radius, double height, std::uint32_t slices) {
    HACHURE_ASSERT(slices >= 3, "a cylinder has at least 3 slices");
    Shape shape;
    for (std::uint32_t i = 0; i <= slices; ++i) {
        const glm::dvec3 n = around_y(static_cast<double>(i % slices) / slices), up(0.0, 0.5 * height, 0.0);
        const double u = static_cast<double>(i) / slices;
        const std::uint32_t a = add(shape, radius * n - up, n, {u, 0.0});
        add(shape, radius * n + up, n, {u, 1.0});
        if (i < slices) quad(shape, a, a + 2, a + 3, a + 1);
    }
    add_disc(shape, radius, 0.5 * height, 1.0, slices);
    add_disc(shape, radius, -0.5 * height, -1.0, slices);
    return shape;
}

Shape cone(double radius, double height, std::uint32_t slices) {
    HACHURE_ASSERT(slices >= 3, "a cone has at least 3 slices");
    Shape shape;
    const glm::dvec3 tip(0.0, 0.5 * height, 0.0);
    const auto slope = [&](double turns) { return height * around_y(turns) + glm::dvec3(0.0, radius, 0.0); };
    for (std::uint32_t i = 0; i <= slices; ++i) {
        const double u = static_cast<double>(i) / slices, turns = static_cast<double>(i % slices) / slices;
        const std::uint32_t a = add(shape, radius * around_y(turns) - tip, slope(turns), {u, 0.0});
        if (i == slices) break;
        add(shape, tip, slope(u + 0.5 / slices), {u + 0.5 / slices, 1.0});
        triangle(shape, a, a + 2, a + 1);
    }
    add_disc(shape, radius, -0.5 * height, -1.0, slices);
    return shape;
}

Shape plane(double size, std::uint32_t cells) {
    HACHURE_ASSERT(cells >= 1, "a plane has at least one cell");
    Shape shape;
    add_square(shape, glm::dvec3(0.0), {size, 0.0, 0.0}, {0.0, 0.0, -size}, cells);
    return shape;
}

Shape cube(double size) {
    Shape shape;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            glm::dvec3 n(0.0), u(0.0), v(0.0);
            n[axis] = side;
            u[(axis + 1) % 3] = side * size;
            v[(axis + 2) % 3] = size;
            add_square(shape, 0.5 * size * n, u, v, 1);
        }
    return shape;
}

} // namespace hachure::geometry
