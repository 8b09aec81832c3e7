#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/model/spawn_model.h>

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <string_view>
#include <vector>

/// A way to draw the part, and what it is called below it.
struct Look {
    std::string_view label;
    void (*dress)(hachure::World& world, hachure::Entity surface, float line_width);
};

/// Those of figure 10 of Gooch 1998, from left to right.
extern const std::array<Look, 4> figure_10;

/// One model in all looks side by side, or two by two where the canvas is not wide enough; a label below each.
class Figure {
public:
    /// Lines are `line_width` pixels wide.
    Figure(hachure::App& app, const hachure::assets::Model& model, float line_width);

    /// Places everything for a canvas.
    void arrange(hachure::Canvas canvas);
    /// Turns all copies alike, radians.
    void turn(float yaw, float pitch);

private:
    struct Copy {
        hachure::SpawnedModel model;
        hachure::Entity label;
        float label_width; ///< of letters 1 high
    };

    hachure::App& app_;
    std::vector<Copy> copies_;
    hachure::Entity camera_;
    glm::vec3 middle_{0.0f};
    float radius_ = 1.0f;
    glm::quat rotation_;
    std::vector<glm::vec3> places_{};
};
