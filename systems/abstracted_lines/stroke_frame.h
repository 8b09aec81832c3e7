#pragma once

#include <hachure/components/abstracted_lines.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/stroke_set.h>
#include <hachure/runtime/scene/view.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace hachure {

/// What strokes need to know of the entity that they belong to.
struct StrokeOwner {
    Entity entity; ///< null: an object without lines
    AbstractedLines lines;
    glm::dmat4 entity_from_world{1.0};
    glm::vec2 origin{0.0f};       ///< the middle of its mesh in the picture, pixels
    float pixels_per_unit = 1.0f; ///< of its own space, at that middle
    float width = 1.0f;           ///< full width of its lines, pixels
};

/// A texture that is as large as its entity: two sizes of it, an octave apart, of which the one fades as the other
/// comes, so that it moves as one with what is zoomed and still has about one size on the screen (as Benard et al.
/// 2009 do for solid textures).
struct TextureOctaves {
    float length = 1.0f; ///< of the larger one, pixels; the other has half of it
    float blend = 0.0f;  ///< 0: the larger alone, 1: the smaller
};

/// For a texture of about `wanted` pixels on an entity of that scale.
[[nodiscard]] TextureOctaves texture_octaves(float wanted, float pixels_per_unit);

/// What this frame makes strokes of. A resource.
struct StrokeFrame {
    std::vector<StrokeOwner> owners; ///< by object id; empty: no strokes
    bool drawn = false;              ///< some entity is drawn as strokes
    std::uint64_t forgotten = 0;     ///< counts the frames without, which forget the strokes
};

/// "abstracted_lines.strokes": fills the frame, and asks for what strokes are made of.
void select_strokes(Query<const AbstractedLines> styled, const DrawList& list, const MeshStore& store, const View& view,
                    FrameRequests& requests, StrokeFrame& frame, StrokeSet& set);

} // namespace hachure
