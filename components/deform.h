#pragma once

#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/geometry/skin.h>

namespace hachure {

enum class DeformedNormals { blended, recomputed };
enum class DeformDevice { cpu, gpu };

/// How a skinned or morphing surface deforms; one that carries no Deform does as the defaults say.
struct Deform {
    geometry::SkinMethod method = geometry::SkinMethod::linear;
    DeformedNormals normals = DeformedNormals::blended;
    /// A wish: a surface whose positions something needs on the CPU is deformed there (see systems/deform/deform.h).
    DeformDevice device = DeformDevice::cpu;

    friend bool operator==(const Deform&, const Deform&) = default;
};

inline void reflect(TypeBuilder<Deform>& type) {
    type.name("deform").doc("how a skinned or morphing surface deforms");
    type.field("method", &Deform::method)
        .doc("how joints are blended: linear is fastest and what files are made for, dual quaternions keep the volume")
        .options({"linear", "dual_quaternion"});
    type.field("normals", &Deform::normals)
        .doc("blended with the joints, or recomputed from the deformed surface: dearer, and right where it bends")
        .options({"blended", "recomputed"});
    type.field("device", &Deform::device)
        .doc("cpu is what lines and strokes need; gpu saves the upload where only shading looks at the surface")
        .options({"cpu", "gpu"});
}

} // namespace hachure
