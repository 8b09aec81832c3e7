#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

namespace hachure {

/// What the width of a line is measured in.
enum class LineWidthUnit {
    pixels,  ///< constant on the screen, thinner in a larger picture
    picture, ///< thousandths of the picture's height: the same look at any resolution
    world,   ///< metres: true to distance and field of view
};

/// Where lines come from.
enum class LineMethod {
    mesh,  ///< the mesh's own edges: exact, one pass over the lines
    image, ///< differences of depth, normal and object between pixels: cheap, whatever the mesh
};

/// What decides where a line is seen.
enum class LineVisibility {
    depth, ///< a depth buffer of two samples per pixel and axis: any mesh
    exact, ///< every line is clipped against the triangles before it: on the CPU, exact, ends are known
};

/// What becomes of lines behind surfaces.
enum class HiddenLines { none, dashed, solid };

/// Lines along silhouettes, creases, borders and more of the entity's mesh, drawn where they are visible.
struct EdgeLines {
    bool silhouette = true;
    bool smooth_silhouette = false;
    bool crease = true;
    bool border = true;
    bool material = false;
    bool intersection = false;
    bool suggestive = false;
    float crease_angle = 1.1f;
    float suggestive_threshold = 2.0f;
    float width = 2.0f;
    LineWidthUnit width_unit = LineWidthUnit::pixels;
    float taper = 0.0f;
    glm::vec3 color{0.0f};
    bool color_by_kind = false;
    glm::vec3 crease_color{0.02f, 0.1f, 0.35f};
    glm::vec3 border_color{0.0f, 0.25f, 0.08f};
    glm::vec3 material_color{0.35f, 0.2f, 0.0f};
    glm::vec3 intersection_color{0.5f, 0.02f, 0.02f};
    glm::vec3 suggestive_color{0.1f, 0.1f, 0.1f};
    bool crease_highlight = false;
    glm::vec3 highlight_color{1.0f};
    HiddenLines hidden = HiddenLines::none;
    glm::vec3 hidden_color{0.35f};
    float hidden_width = 0.6f;
    float dash = 4.0f;
    LineMethod method = LineMethod::mesh;
    LineVisibility visibility = LineVisibility::exact;

    friend bool operator==(const EdgeLines&, const EdgeLines&) = default;
};

inline void reflect(TypeBuilder<EdgeLines>& type) {
    type.name("edge_lines").doc("lines along silhouettes, creases, borders and more");
    type.field("silhouette", &EdgeLines::silhouette).doc("draw edges between a front face and a back face");
    type.field("smooth_silhouette", &EdgeLines::smooth_silhouette)
        .doc("draw silhouettes inside triangles, where the interpolated normal turns away, instead of along edges");
    type.field("crease", &EdgeLines::crease).doc("draw edges whose faces meet at more than crease_angle");
    type.field("border", &EdgeLines::border).doc("draw edges with one face");
    type.field("material", &EdgeLines::material).doc("draw edges between two materials");
    type.field("intersection", &EdgeLines::intersection)
        .doc("draw where the surface cuts itself or another surface that carries edge lines");
    type.field("suggestive", &EdgeLines::suggestive).doc("draw suggestive contours, faded where they are weak");
    type.field("crease_angle", &EdgeLines::crease_angle)
        .doc("angle between the face normals from which an edge is a crease")
        .unit("rad")
        .range(0, 3.1416);
    type.field("suggestive_threshold", &EdgeLines::suggestive_threshold)
        .doc("how fast curvature must change for a suggestive contour, for a model of size 1; more gives fewer lines")
        .range(0, 1000);
    type.field("width", &EdgeLines::width).doc("width of the line, in width_unit").range(0, 1000);
    type.field("width_unit", &EdgeLines::width_unit)
        .doc("pixels; thousandths of the picture's height, for the same look at any resolution; or metres in the "
             "world, true to distance and field of view")
        .options({"pixels", "picture", "world"});
    type.field("taper", &EdgeLines::taper)
        .doc("length over which a line thins out towards its ends, in widths; 0 for none")
        .range(0, 1000);
    type.field("color", &EdgeLines::color).color().doc("colour of the line; of silhouettes alone with color_by_kind");
    type.field("color_by_kind", &EdgeLines::color_by_kind).doc("give the other kinds colours of their own");
    type.field("crease_color", &EdgeLines::crease_color).color().doc("colour of creases with color_by_kind");
    type.field("border_color", &EdgeLines::border_color).color().doc("colour of borders with color_by_kind");
    type.field("material_color", &EdgeLines::material_color)
        .color()
        .doc("colour of material boundaries with color_by_kind");
    type.field("intersection_color", &EdgeLines::intersection_color)
        .color()
        .doc("colour of intersections with color_by_kind");
    type.field("suggestive_color", &EdgeLines::suggestive_color)
        .color()
        .doc("colour of suggestive contours with color_by_kind");
    type.field("crease_highlight", &EdgeLines::crease_highlight)
        .doc("draw creases as highlights, in highlight_color: edges that catch the light");
    type.field("highlight_color", &EdgeLines::highlight_color).color().doc("colour of creases drawn as highlights");
    type.field("hidden", &EdgeLines::hidden)
        .doc("what becomes of lines behind surfaces; the AOV hidden_lines holds them in any case")
        .options({"none", "dashed", "solid"});
    type.field("hidden_color", &EdgeLines::hidden_color).color().doc("colour of hidden lines");
    type.field("hidden_width", &EdgeLines::hidden_width).doc("width of hidden lines, in widths").range(0, 10);
    type.field("dash", &EdgeLines::dash).doc("length of a dash of hidden lines, in widths of theirs").range(0.5, 1000);
    type.field("method", &EdgeLines::method)
        .doc("lines of the mesh, exact; or from differences between pixels, the cheap choice")
        .options({"mesh", "image"});
    type.field("visibility", &EdgeLines::visibility)
        .doc("what decides where lines of the mesh are seen: a finer depth buffer, or clipping against the triangles "
             "on the CPU (where a shape is on the GPU alone, the depth buffer does)")
        .options({"depth", "exact"});
}

} // namespace hachure
