#pragma once

#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/view.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "looks.h"

namespace hill_walk {

/// Component of a figure that follows the path through the hills.
struct Walker {
    double at = 0.0;    ///< angle of its place on the circle of the path, radians
    double speed = 1.3; ///< metres a second
};

/// The hills and two figures that walk in them, each in a look of its own.
class HillWalk {
public:
    enum Part : std::size_t { ground, first_figure, second_figure, part_count };

    /// `files` has the models of the figures, two at most; lay figures take the place of those that are missing.
    /// A figure plays its clip whose name contains "walk", or its first one. Throws Error for files that cannot be
    /// shown.
    HillWalk(hachure::App& app, const std::vector<std::string>& files, hachure::Canvas canvas);

    [[nodiscard]] hachure::Entity camera() const { return camera_; }
    [[nodiscard]] const std::string& look_of(Part part) const { return parts_[part].look; }

    void next_look(Part part);
    void set_walking(bool walking);
    [[nodiscard]] bool walking() const;

    /// Every brush of one part.
    [[nodiscard]] std::vector<hachure::Entity> brushes(Part part) const;

private:
    struct Dressed {
        hachure::Entity root;
        std::vector<hachure::Entity> surfaces;
        std::size_t look_number = 0;
        std::string look;
    };

    void add_ground();
    void add_figure(Part part, const std::string& file);
    void add_view(hachure::Canvas canvas);
    void wear(Part part, std::size_t look);

    hachure::World& world_;
    hachure::Entity camera_;
    std::array<Dressed, part_count> parts_;
};

} // namespace hill_walk
