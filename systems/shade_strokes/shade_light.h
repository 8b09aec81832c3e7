#pragma once

#include <hachure/runtime/scene/light_list.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>
#include <hachure/systems/shade_strokes/shade_settings.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// From where a surface is seen; counts where a light turns with the gaze alone.
struct ShadeEye {
    glm::vec3 place{0.0f};            ///< of a perspective camera, in the world
    glm::vec3 axis{0.0f, 0.0f, 1.0f}; ///< unit, from the scene to the camera: the camera's +Z
    bool perspective = true;

    friend bool operator==(const ShadeEye&, const ShadeEye&) = default;
};

/// How much shade every cell needs: one less the diffuse light on it (as shaders/gooch/tone_light has it, lights adding
/// up), shaped by a tone curve. Without any light all is dark. Works on several threads, with the same bits on any
/// number of them; allocates nothing after the first run.
struct ShadeLightJob {
    const ShadeMesh* mesh = nullptr;
    std::span<const glm::vec3> positions{};   ///< as deformed, in the mesh's space
    std::span<const glm::vec3> normals{};     ///< unit, one per vertex, as deformed; or none: those of triangles
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle, as the ShadeMesh was made from
    std::uint64_t version = 0;                ///< another one whenever mesh, positions, normals or paint are
    glm::mat4 world_from_mesh{1.0f};
    std::span<const ShadingLight> lights{}; ///< those with a number that is none are left out
    ShadeEye eye{};
    ShadeTone tone{};
    std::span<const float> paint{}; ///< per cell: what its need is multiplied with, in [0, 1]; or none
    std::span<float> needed{};      ///< in and out, one per cell, in [0, 1]: keep it from run to run

    bool swept = false;             ///< out: whether anything was computed; false when all was as in the run before
    std::size_t ignored_lights = 0; ///< out: how many were left out

    /// Asserts that sizes agree.
    void validate() const;
    void run();

    /// Kept from run to run: what the last sweep was made with.
    struct Inputs {
        std::vector<ShadingLight> lights;
        glm::mat4 world_from_mesh{0.0f};
        ShadeEye eye;
        ShadeTone tone;
        const ShadeMesh* mesh = nullptr;
        std::uint64_t version = 0;

        friend bool operator==(const Inputs&, const Inputs&) = default;
    };
    Inputs now{}, last{};
    struct Sample {
        glm::vec3 place, normal; ///< in the world; the normal is unit, or 0
    };
    std::vector<Sample> samples{}; ///< per sample of the mesh: gathered anew when the surface moves, not when lights do
};

} // namespace hachure
