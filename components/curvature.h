#pragma once

#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/geometry/curvature.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hachure {

enum class CurvatureSource { recomputed, carried };

/// Asks for the principal curvatures of a surface: a PrincipalCurvatures beside it.
struct Curvature {
    CurvatureSource source = CurvatureSource::recomputed;
    geometry::CurvatureMethod method = geometry::CurvatureMethod::one_ring;
    bool fill = false;

    friend bool operator==(const Curvature&, const Curvature&) = default;
};

inline void reflect(TypeBuilder<Curvature>& type) {
    type.name("curvature")
        .doc("asks for the principal curvatures of a surface; shade strokes on it then follow how it bends");
    type.field("source", &Curvature::source)
        .doc("of a surface that deforms: recomputed from its shape, or carried from its rest pose by its joints, which "
             "is cheaper and wrong where it bends")
        .options({"recomputed", "carried"});
    type.field("method", &Curvature::method)
        .doc("what curvatures are taken from: one_ring is cheapest and errs by some percent, quadric and quartic fit "
             "polynomials to more of the mesh, automatic to as much of it as its noise asks for")
        .options({"one_ring", "quadric", "quartic", "automatic"});
    type.field("fill", &Curvature::fill)
        .doc("make a smooth field of the directions: at umbilics and on flat parts, which have none, they are the mean "
             "of those around");
}

/// How a surface bends at each vertex, in entity space; systems/curvature computes it, and again when the shape
/// changed.
struct PrincipalCurvatures {
    std::vector<glm::vec2> curvatures; ///< k1, k2 with |k1| >= |k2|, 1/m; positive where it bends away from its normal
    std::vector<glm::vec3> directions; ///< unit, of k1; of k2 it is cross(normal, direction)
    /// Where Curvature::fill asks for it, else none: in [0, 1], how much there was to each direction before.
    std::vector<float> confidences;
    std::uint64_t version = 0; ///< of the Deformed that it belongs to; 0 for the mesh's own shape
};

} // namespace hachure
