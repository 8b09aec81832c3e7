#pragma once

#include <hachure/components/shade_strokes.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/view.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sun_walk {

/// Component of a figure that follows the path.
struct Walker {
    double at = 0.0;    ///< angle of its place on the circle of the path, radians
    double speed = 1.3; ///< metres a second
};

/// Component of the light that goes round the sky in a circle: from the east (+X) over the south (+Z) to the west, and
/// below the ground back to the east.
struct Sun {
    double at = 0.7;                    ///< angle since its rise, radians; pi is its setting
    double day_seconds = 24.0;          ///< how long a day and a night last
    static constexpr float lean = 0.6f; ///< of its circle away from upright, radians
};

/// A figure that walks on dunes under a sun that goes round the sky.
class Day {
public:
    /// `file` has the model of the figure; empty for a lay figure. It plays its clip whose name contains "walk", or its
    /// first one. Throws Error for a file that cannot be shown.
    Day(hachure::App& app, const std::string& file, hachure::Canvas canvas);

    [[nodiscard]] hachure::Entity camera() const { return camera_; }
    [[nodiscard]] std::string_view look() const;

    void next_look();
    void set_walking(bool walking);
    [[nodiscard]] bool walking() const;
    void set_sun_moving(bool moving);
    [[nodiscard]] bool sun_moving() const;
    /// Puts the sun at an angle since its rise.
    void place_sun(double at);

private:
    void add_ground();
    void add_figure(const std::string& file);
    void add_view(hachure::Canvas canvas);
    void wear(std::size_t look);

    hachure::World& world_;
    hachure::Entity camera_, figure_, sun_;
    std::vector<hachure::Entity> ground_, body_; ///< what carries surfaces
    std::size_t look_ = 0;
};

} // namespace sun_walk
