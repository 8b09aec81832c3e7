#pragma once

#include <hachure/components/camera.h>
#include <hachure/components/gooch.h>
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

/// What the picture of a sphere and of a square must be, by ray casting in double precision. Shares no code with the
/// shaders or the systems.
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

/// A unit sphere, or the square [-1, 1]^2 in z = 0 that faces +Z, behind a transform.
struct CastObject {
    enum Kind { sphere, square } kind;
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
        Hit hit;
        dvec3 normal(0.0, 0.0, 1.0);
        if (kind == sphere) {
            const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1.0;
            if (b * b < a * c) return std::nullopt;
            hit.depth = (-b - std::sqrt(b * b - a * c)) / a;
            normal = o + hit.depth * d;
        } else {
            hit.depth = -o.z / d.z;
            const dvec3 p = o + hit.depth * d;
            if (std::max(std::abs(p.x), std::abs(p.y)) > 1.0) return std::nullopt;
        }
        hit.normal = glm::normalize(glm::transpose(glm::dmat3(inverse)) * normal);
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

/// Whether all pixels within 2 of this one show the same object: whether it is away from every outline.
inline bool away_from_outlines(const std::vector<Hit>& hits, Canvas canvas, int column, int row) {
    const auto object = [&](int x, int y) { return hits[static_cast<std::size_t>(y * canvas.width + x)].object; };
    for (int y = std::max(0, row - 2); y <= std::min(canvas.height - 1, row + 2); ++y)
        for (int x = std::max(0, column - 2); x <= std::min(canvas.width - 1, column + 2); ++x)
            if (object(x, y) != object(column, row)) return false;
    return true;
}

/// Equations 2 and 3 of Gooch 1998 with the warm tone on the lit side, or as printed; then Phong's highlight.
inline dvec3 gooch_color(const Gooch& gooch, const dvec3& k_d, const dvec3& n, const dvec3& l, const dvec3& to_eye) {
    const dvec3 cool = dvec3(0.0, 0.0, double(gooch.b)) + double(gooch.alpha) * k_d;
    const dvec3 warm = dvec3(double(gooch.y), double(gooch.y), 0.0) + double(gooch.beta) * k_d;
    const double weight = 0.5 * (1.0 + glm::dot(l, n));
    const dvec3 tone =
        gooch.printed_equation ? weight * cool + (1.0 - weight) * warm : weight * warm + (1.0 - weight) * cool;
    const dvec3 mirrored = 2.0 * glm::dot(l, n) * n - l;
    const double phong = std::pow(std::max(0.0, glm::dot(mirrored, glm::normalize(to_eye))), double(gooch.shininess));
    const double share = double(gooch.highlight) * phong;
    return (1.0 - share) * tone + share * dvec3(1.0);
}

} // namespace hachure::test
