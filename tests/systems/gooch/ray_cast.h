#pragma once

#include <hachure/components/camera.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/scene/view.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

/// What a camera sees of spheres, squares, cylinders and tori, by ray casting in double precision. Shares no code with
/// the shaders or the systems.
namespace hachure::test {

using glm::dvec3;

struct Ray {
    dvec3 origin, direction; ///< the direction advances depth by 1
};

class RayCamera {
public:
    RayCamera(const Camera& camera, const Transform& place, Canvas canvas)
        : camera_(camera), canvas_(canvas), eye_(place.translation), right(glm::dquat(place.rotation) * dvec3(1, 0, 0)),
          up(glm::dquat(place.rotation) * dvec3(0, 1, 0)), back(glm::dquat(place.rotation) * dvec3(0, 0, 1)) {}

    /// Through the centre of a pixel; row 0 is the top.
    [[nodiscard]] Ray ray(int column, int row) const {
        const double aspect = static_cast<double>(canvas_.width) / canvas_.height;
        const double x = ((column + 0.5) / canvas_.width * 2.0 - 1.0) * aspect;
        const double y = 1.0 - (row + 0.5) / canvas_.height * 2.0;
        if (camera_.projection == Projection::orthographic)
            return {eye_ + double(camera_.ymag) * (x * right + y * up), -back};
        const double slope = std::tan(0.5 * double(camera_.yfov));
        return {eye_, slope * (x * right + y * up) - back};
    }

    /// Unit vector from a point towards the eye.
    [[nodiscard]] dvec3 to_eye(const dvec3& point) const {
        return camera_.projection == Projection::orthographic ? back : glm::normalize(eye_ - point);
    }

    /// Unit vector from what is seen towards the eye, in the middle of the picture.
    [[nodiscard]] dvec3 axis() const { return back; }

    /// Gooch's: up and to the right, perpendicular to the gaze.
    [[nodiscard]] dvec3 light() const { return (right + up) / std::sqrt(2.0); }

private:
    Camera camera_;
    Canvas canvas_;
    dvec3 eye_;
    dvec3 right, up, back;
};

struct Hit {
    double depth = 1e10;
    dvec3 normal{0.0}; ///< in the world, unit, on the side that is seen
    int object = 0;    ///< counted from 1; 0 where nothing is
};

/// Where a ray enters a surface in the surface's own space; no more than what the ray has advanced and the normal
/// there.
struct LocalHit {
    double depth;
    dvec3 normal;
};

inline std::optional<LocalHit> cast_sphere(const dvec3& o, const dvec3& d) {
    const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1.0;
    if (b * b < a * c) return std::nullopt;
    const double t = (-b - std::sqrt(b * b - a * c)) / a;
    return LocalHit{t, o + t * d};
}

inline std::optional<LocalHit> cast_square(const dvec3& o, const dvec3& d) {
    const double t = -o.z / d.z;
    const dvec3 p = o + t * d;
    if (std::max(std::abs(p.x), std::abs(p.y)) > 1.0) return std::nullopt;
    return LocalHit{t, {0.0, 0.0, 1.0}};
}

inline std::optional<LocalHit> cast_cylinder(const dvec3& o, const dvec3& d) {
    const double a = d.x * d.x + d.z * d.z, b = o.x * d.x + o.z * d.z, c = o.x * o.x + o.z * o.z - 1.0;
    if (a > 0.0 && b * b >= a * c) {
        const double t = (-b - std::sqrt(b * b - a * c)) / a;
        const dvec3 p = o + t * d;
        if (std::abs(p.y) <= 1.0) return LocalHit{t, {p.x, 0.0, p.z}};
    }
    const double end = d.y < 0.0 ? 1.0 : -1.0;
    const double t = (end - o.y) / d.y;
    const dvec3 p = o + t * d;
    if (p.x * p.x + p.z * p.z > 1.0) return std::nullopt;
    return LocalHit{t, {0.0, end, 0.0}};
}

constexpr double torus_minor = 0.4; ///< the radius of the tube around the unit circle

/// Walks along the ray by the distance to the torus, which never steps over it.
inline std::optional<LocalHit> cast_torus(const dvec3& o, const dvec3& d) {
    const double length = glm::length(d);
    double t = std::max(0.0, (-glm::dot(o, d) / length - 2.0) / length);
    for (int step = 0; step < 2000; ++step) {
        const dvec3 p = o + t * d;
        const double out = std::hypot(p.x, p.z), distance = std::hypot(out - 1.0, p.y) - torus_minor;
        if (distance < 1e-11) return LocalHit{t, p - dvec3(p.x, 0.0, p.z) / out};
        t += distance / length;
        if (glm::dot(p, d) > 0.0 && glm::length(p) > 1.5) return std::nullopt;
    }
    return std::nullopt;
}

/// A unit sphere; the square [-1, 1]^2 in z = 0 that faces +Z; the cylinder of radius 1 and height 2 along Y, with its
/// caps; or the torus around the unit circle in y = 0; behind a transform.
struct CastObject {
    enum Kind { sphere, square, cylinder, torus } kind;
    Transform transform;
    dvec3 color;
    bool double_sided = false;

    [[nodiscard]] glm::dmat4 matrix() const {
        glm::dmat4 m = glm::mat4_cast(glm::dquat(transform.rotation));
        for (int axis = 0; axis < 3; ++axis) m[axis] *= double(transform.scale[axis]);
        m[3] = glm::dvec4(dvec3(transform.translation), 1.0);
        return m;
    }

    [[nodiscard]] std::optional<Hit> cast(const Ray& ray) const {
        const glm::dmat4 inverse = glm::inverse(matrix());
        const dvec3 o(inverse * glm::dvec4(ray.origin, 1.0)), d(inverse * glm::dvec4(ray.direction, 0.0));
        constexpr std::optional<LocalHit> (*casts[])(const dvec3&, const dvec3&) = {cast_sphere, cast_square,
                                                                                    cast_cylinder, cast_torus};
        const std::optional<LocalHit> local = casts[kind](o, d);
        if (!local) return std::nullopt;
        Hit hit{.depth = local->depth};
        hit.normal = glm::normalize(glm::transpose(glm::dmat3(inverse)) * local->normal);
        if (glm::dot(hit.normal, ray.direction) > 0.0) {
            if (!double_sided) return std::nullopt;
            hit.normal = -hit.normal;
        }
        return hit;
    }
};

/// The nearest hit of every pixel, row by row from the top.
inline std::vector<Hit> cast_all(const std::vector<CastObject>& objects, const RayCamera& camera, Canvas canvas) {
    std::vector<Hit> hits;
    for (int row = 0; row < canvas.height; ++row)
        for (int column = 0; column < canvas.width; ++column) {
            Hit nearest;
            for (std::size_t i = 0; i < objects.size(); ++i) {
                std::optional<Hit> hit = objects[i].cast(camera.ray(column, row));
                if (!hit || hit->depth >= nearest.depth) continue;
                nearest = *hit;
                nearest.object = static_cast<int>(i) + 1;
            }
            hits.push_back(nearest);
        }
    return hits;
}

/// Whether all pixels within 2 of this one show the same object, and no edge or fold of it: whether it is away from
/// every outline.
inline bool away_from_outlines(const std::vector<Hit>& hits, Canvas canvas, int column, int row) {
    const auto at = [&](int x, int y) -> const Hit& { return hits[static_cast<std::size_t>(y * canvas.width + x)]; };
    const Hit& here = at(column, row);
    for (int y = std::max(0, row - 2); y <= std::min(canvas.height - 1, row + 2); ++y)
        for (int x = std::max(0, column - 2); x <= std::min(canvas.width - 1, column + 2); ++x) {
            const Hit& near = at(x, y);
            if (near.object != here.object) return false;
            if (here.object != 0 && glm::dot(near.normal, here.normal) < 0.85) return false;
        }
    return true;
}

} // namespace hachure::test
