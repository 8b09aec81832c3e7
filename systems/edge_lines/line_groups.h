#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/systems/edge_lines/line_set.h>
#include <hachure/systems/edge_lines/project_lines.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// Segments of an entity that are drawn with one call.
struct LineDraw {
    Entity entity;
    SegmentRange segments;
    float width_factor = 1.0f;
    float taper = 0.0f;
    float dash = 0.0f;
    bool hidden = false; ///< where the line is hidden instead of where it is seen
    bool exact = false;  ///< the segments are clipped already: all of each is drawn
};

/// Lines of one colour that lie on one layer: they are combined by their maximum, so that joints don't darken, and then
/// laid over the groups before.
struct LineGroup {
    glm::vec3 color{0.0f};
    std::vector<LineDraw> draws;
};

/// What colour lines of a kind have.
[[nodiscard]] glm::vec3 color_of(const EdgeLines& lines, DrawnKind kind);

/// Puts lines into the order in which they are drawn: hidden ones below, then kind by kind (DrawnKind). Neighbours of
/// one colour share a group: with default looks there is one.
class LineGroups {
public:
    void clear() { groups_.clear(); }
    void add(const glm::vec3& color, const LineDraw& draw);
    [[nodiscard]] std::span<const LineGroup> groups() const { return groups_; }

private:
    std::vector<LineGroup> groups_;
};

} // namespace hachure
