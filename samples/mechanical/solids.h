#pragma once

#include <hachure/runtime/assets/model.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <vector>

/// Turned and milled solids about the Y axis with exact normals and hard edges, in metres. Points of different faces
/// that stand at one place are equal in every bit, so that edges are found across faces.
///
/// `segments` points make a full circle everywhere: number k stands at k/segments of a turn.
constexpr int segments = 120;

/// The point at that distance from the axis and height, at `k` segments' angle; k may be broken.
[[nodiscard]] glm::dvec3 polar(double radius, double height, double k);

/// What stands in the half plane of a turned profile: distance from the axis and height.
using Profile = std::vector<glm::dvec2>;

/// Points of an arc from `begin` to `end`, radians from the radius towards the height.
[[nodiscard]] Profile arc(glm::dvec2 centre, double radius, double begin, double end, int pieces = 8);

using Loop = std::vector<glm::dvec3>; ///< closed, in order of its angle around a centre

/// A circle of the plane y = `height` around a point at `distance` on the ray of `k` segments.
[[nodiscard]] Loop circle(double distance, double k, double radius, double height, int points);
/// Equal sides; the first corner towards +X.
[[nodiscard]] Loop hexagon(double radius, double height);

/// The primitive being made. Every face shows its front on the side of its normals.
class Solid {
public:
    /// Turns a straight run of the profile: a cylinder, cone or disc. `outside`: roughly where its normals point.
    void turn_line(glm::dvec2 from, glm::dvec2 to, glm::dvec2 outside);
    /// Turns an arc; `sign` 1 for a bulge, -1 for a hollow.
    void turn_arc(glm::dvec2 centre, double radius, double begin, double end, double sign);
    /// The flat face between two loops around `centre`; an empty inner loop is the centre itself.
    void face(const Loop& outer, const Loop& inner, glm::dvec3 centre, glm::dvec3 normal);
    /// A wall between two loops of equally many points; facets of their own, or smooth with the normals given per
    /// point.
    void wall(const Loop& low, const Loop& high, glm::dvec3 inside, double sign);
    void smooth_wall(const Loop& low, const Loop& high, const std::vector<glm::dvec3>& normals);
    /// The cylinder of a hole's circle, seen from within.
    void hole(const Loop& low, const Loop& high, glm::dvec3 centre);
    /// A smooth sheet over `rows` x `segments` that closes around the axis; its normals come from `at`(row, k).
    void sheet(int rows, const std::function<glm::dvec3(double row, double k)>& at);
    /// An annulus with `count` holes on the circle at `distance`, in the plane y = `height`; a sector each, from half a
    /// sector before the hole to half of one after it. The first hole is at `first` segments.
    void holed_face(double inner, double outer, double height, double up, int count, double distance, double radius,
                    int first);

    [[nodiscard]] hachure::assets::Primitive finish(int material);

private:
    void triangle(const glm::dvec3* points, const glm::dvec3* normals);
    void quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d, const glm::dvec3& na,
              const glm::dvec3& nb, const glm::dvec3& nc, const glm::dvec3& nd);

    hachure::assets::Primitive made_;
};
