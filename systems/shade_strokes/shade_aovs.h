#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/frame_requests.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// What the AOVs show besides the ShadeFrame. A resource.
struct ShadeNeeds {
    struct Surface {
        std::span<const float> needed;        ///< per cell
        std::span<const glm::vec3> positions; ///< per vertex, as drawn
    };
    std::vector<Surface> surfaces; ///< as in the ShadeFrame
    std::uint64_t key = 0;         ///< changes with any need and any shape
};

/// Names the AOVs of shade strokes.
void know_shade_aovs(FrameRequests& requests);

/// Asks those who draw strokes for what the AOVs need of them; before they declare their passes.
void request_shade_sources(FrameRequests& requests);

/// Declares the passes of those that are asked for: `shade_needed` and `shade_delivered` draw each shaded surface with
/// the values of its cells, `stroke_coverage` hands on the texture `shade_coverage` of those who draw strokes. All are
/// made anew, with their buffers, when what they show changed: they are for looking, not for films.
class ShadeAovs {
public:
    void declare(World& world);

private:
    enum class Value { needed, delivered };

    void declare_cells(World& world, const char* name, Value value);
    static void declare_coverage(World& world);
    void draw(World& world, std::size_t surface, Value value);
    void upload(World& world, std::size_t surface, Value value);

    /// Of its own for each surface and value: a driver may read a buffer after the call that draws with it.
    struct Buffers {
        gpu::Buffer corners, triangles, cells, shade;
        gpu::VertexArray vertex_array;
    };
    [[nodiscard]] Buffers& buffers(std::size_t surface, Value value) {
        return buffers_[static_cast<std::size_t>(value)][surface];
    }

    std::array<std::vector<Buffers>, 2> buffers_; ///< by value, by surface
    std::vector<glm::vec3> corner_scratch_;
    std::vector<glm::uvec2> triangle_scratch_;
    std::vector<float> shade_scratch_;
};

} // namespace hachure
