#include <hachure/systems/edge_lines/line_groups.h>

namespace hachure {

glm::vec3 color_of(const EdgeLines& lines, LineKind kind) {
    if (kind == LineKind::crease && lines.crease_highlight) return lines.highlight_color;
    if (!lines.color_by_kind) return lines.color;
    switch (kind) {
    case LineKind::suggestive:
        return lines.suggestive_color;
    case LineKind::material:
        return lines.material_color;
    case LineKind::crease:
        return lines.crease_color;
    case LineKind::intersection:
        return lines.intersection_color;
    case LineKind::border:
        return lines.border_color;
    case LineKind::silhouette:
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
