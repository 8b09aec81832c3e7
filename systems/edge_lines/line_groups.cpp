#include <hachure/systems/edge_lines/line_groups.h>

namespace hachure {

glm::vec3 color_of(const EdgeLines& lines, DrawnKind kind) {
    if (kind == DrawnKind::crease && lines.crease_highlight) return lines.highlight_color;
    if (!lines.color_by_kind) return lines.color;
    switch (kind) {
    case DrawnKind::suggestive:
        return lines.suggestive_color;
    case DrawnKind::material:
        return lines.material_color;
    case DrawnKind::crease:
        return lines.crease_color;
    case DrawnKind::intersection:
        return lines.intersection_color;
    case DrawnKind::border:
        return lines.border_color;
    case DrawnKind::silhouette:
        break;
    }
    return lines.color;
}

void LineGroups::add(const glm::vec3& color, const LineDraw& draw) {
    if (draw.segments.count == 0) return;
    if (groups_.empty() || groups_.back().color != color) groups_.push_back({color, {}});
    groups_.back().draws.push_back(draw);
}

} // namespace hachure
