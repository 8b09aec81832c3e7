#pragma once

#include <hachure/components/metal.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/model/spawn_model.h>

#include <glm/gtc/quaternion.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

/// One model in one look, and what it is called below it.
struct Cell {
    const hachure::assets::Model* model; ///< must outlive the figure
    std::string label;
    /// Gives the spawned model its components; lines are `line_width` pixels wide.
    std::function<void(hachure::App&, const hachure::SpawnedModel&, float line_width)> dress;
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    float zoom = 1.0f; ///< 1: its rest pose fills the cell
};

/// The looks of figure 10 of Gooch 1998, from left to right, of one model, and what its stripes follow.
std::vector<Cell> figure_10(const hachure::assets::Model& model, hachure::MetalSource stripes, glm::quat rotation);

/// From above with the axis leaning, and from half the side.
glm::quat leaning();
glm::quat half_profile();

/// Cells of four side by side, or of two or one where the canvas is not wide enough.
class Figure {
public:
    Figure(hachure::App& app, std::vector<Cell> cells, float line_width);

    /// Places everything for a canvas.
    void arrange(hachure::Canvas canvas);
    /// Turns all models alike, radians.
    void turn(float yaw, float pitch);

private:
    struct Copy {
        hachure::SpawnedModel model;
        hachure::Entity label;
        float label_width; ///< of letters 1 high
        glm::quat rotation;
        glm::vec3 pivot{0.0f}; ///< of the model: what stands in the middle of its cell
        float scale = 1.0f;
        glm::vec3 place{0.0f}; ///< of the pivot
    };

    void fit(Copy& copy, const Cell& cell) const;

    hachure::App& app_;
    std::map<const hachure::assets::Model*, hachure::StoredModel> stored_;
    std::vector<Copy> copies_;
    hachure::Entity camera_;
};
