#pragma once

#include <hachure/runtime/ecs/reflect.h>

namespace hachure {

enum class Projection { perspective, orthographic };

/// Looks along the entity's -Z, +Y up, as in glTF. The first camera that is active draws the view.
struct Camera {
    Projection projection = Projection::perspective;
    float yfov = 0.6f;
    float ymag = 1.0f;
    float znear = 0.01f;
    float zfar = 0.0f;
    bool active = true;

    friend bool operator==(const Camera&, const Camera&) = default;
};

inline void reflect(TypeBuilder<Camera>& type) {
    type.name("camera").doc("the eye of a view; looks along the entity's -Z");
    type.field("projection", &Camera::projection).doc("kind of projection").options({"perspective", "orthographic"});
    type.field("yfov", &Camera::yfov).doc("full vertical angle of view (perspective)").unit("rad").range(0.001, 3.13);
    type.field("ymag", &Camera::ymag).doc("half of the view's height (orthographic)").unit("m").range(1e-9, 1e9);
    type.field("znear", &Camera::znear).doc("nearest depth that is drawn").unit("m").range(1e-9, 1e9);
    type.field("zfar", &Camera::zfar)
        .doc("farthest depth that is drawn; 0 for no limit (1000 half heights in an orthographic view)")
        .unit("m")
        .range(0, 1e12);
    type.field("active", &Camera::active).doc("may draw the view");
}

} // namespace hachure
