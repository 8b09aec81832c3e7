#pragma once

#include <string_view>

namespace hachure {

/// The parts of a frame, in order.
enum class Stage {
    input,     ///< reads window, keyboard, pointer and recorded playback into components
    script,    ///< the user's own logic, timelines and scripts
    animate,   ///< samples clips and drivers into local transforms, joint poses and weights
    transform, ///< local transforms and parents to world transforms
    deform,    ///< skins and morphs meshes, and renews what depends on their shape (normals, bounds, curvature)
    light,     ///< moves lights and decides what each of them reaches
    material,  ///< the CPU side of materials: strokes, maps and tables that follow shape and light
    render,    ///< declares this frame's passes and runs them
};

/// The stage as it is spelled above.
std::string_view to_string(Stage stage);

} // namespace hachure
