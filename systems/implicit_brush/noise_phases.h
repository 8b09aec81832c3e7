#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/vertex_textures.h>
#include <hachure/runtime/scene/view.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace hachure {

struct RenderContext;

/// Textures that say of each pixel where on the screen its surface was when the noise that it carries was made, for
/// both phases. Rgba32f: pixels x and y, moved by a random vector for each surface and period; the logarithm to base 2
/// of how many times as far off the surface is now; and the weight of the phase, 0 where it has none. The squares of
/// the weights add up to 1.
struct PhaseTextures {
    std::uint32_t depth_buffer = 0; ///< in: the surfaces that are seen
    std::array<std::uint32_t, 2> pasts{};
};

/// Noise of the screen that motion carries along (Bousseau et al. 2007), for surfaces.
///
/// There it is moved on from frame to frame, by motion vectors. Here a surface remembers pose and view of the frame in
/// which its noise was last made, which gives the sum of all motion since then without the error that adds up, and
/// needs no picture of the frames between. Motion stretches noise, so it is made anew after a while, by two phases in
/// turn, each when it does not count; its time is the motion that stretches: what stands still, or only moves along the
/// screen, keeps its noise.
///
/// What it remembers follows from all frames since a surface came into view, drawn or not.
class NoisePhases {
public:
    /// `lifetime`: pixels that a surface's points move against each other until noise is made anew.
    explicit NoisePhases(float lifetime) : lifetime_(lifetime) {}

    /// Takes in a frame's list.
    void update(const MeshStore& store, const DrawList& list, const View& view);

    /// All surfaces of the frame taken in last, onto what `textures` hold, in `rect`.
    void draw(const World& world, RenderContext& render, const PhaseTextures& textures, const gpu::Rect& rect);

    [[nodiscard]] float lifetime() const { return lifetime_; }

    /// What the textures follow from.
    [[nodiscard]] std::uint64_t key() const { return key_; }

private:
    /// A surface when noise was made for it.
    struct Pose {
        glm::mat4 clip_from_entity{1.0f};
        glm::vec2 viewport{1.0f};
        float pixel_size = 1.0f;          ///< as View::pixel_size
        std::vector<glm::vec3> positions; ///< empty for the mesh's own
        std::uint64_t version = 0;        ///< how often there was one
    };

    struct Track {
        std::uint32_t mesh = 0;
        glm::mat4 clip_from_entity{1.0f}; ///< of the frame before
        std::uint64_t shape = 0;          ///< version
        std::vector<glm::vec3> samples;   ///< some vertices in the frame before: pixels, and depth before the eye
        double clock = 0.0;               ///< lifetimes
        std::array<Pose, 2> poses;
        std::uint64_t frame = 0; ///< in which it was seen last
    };

    void follow(const MeshStore& store, const DrawItem& item, const View& view, Track& track);
    static void start(const DrawItem& item, const View& view, Pose& pose);
    void draw_item(const World& world, RenderContext& render, const DrawItem& item, const Track& track);

    float lifetime_;
    std::unordered_map<Entity, Track> tracks_;
    std::uint64_t frame_ = 0, key_ = 0;
    std::array<VertexTextures, 2> positions_{VertexTextures("positions of noise 0"),
                                             VertexTextures("positions of noise 1")};
};

/// How two pictures of the same points differ.
struct PointMotion {
    glm::vec2 mean{0.0f};   ///< pixels
    float apart = 0.0f;     ///< RMS of what is left without the mean, pixels
    std::size_t points = 0; ///< that counted
};

/// Of points as (x, y, depth) that were in the view before, or near it, and are before the eye in both pictures.
[[nodiscard]] PointMotion point_motion(std::span<const glm::vec3> before, std::span<const glm::vec3> now,
                                       glm::vec2 viewport);

} // namespace hachure
