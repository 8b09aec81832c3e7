#pragma once

#include <hachure/components/deformed.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

// Shapes that the GPU has made, and how they compare with the CPU's.
namespace hachure::test {

struct Vertices {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec4> tangents;
};

inline const DrawItem* item_of(World& world, Entity entity) {
    for (const DrawItem& item : world.resource<DrawList>().items)
        if (item.entity == entity) return &item;
    return nullptr;
}

/// From the buffer that the surface was last drawn from.
inline Vertices read_back(World& world, Entity entity) {
    Vertices result;
    const DrawItem* item = item_of(world, entity);
    EXPECT_TRUE(item != nullptr && item->shape.on_gpu);
    if (!item || !item->shape.on_gpu) return result;
    GpuMeshes& meshes = world.resource_mutable<RenderContext>().meshes;
    EXPECT_TRUE(meshes.has_shape(*item));
    const MeshStore& store = world.resource<MeshStore>();
    const std::size_t count = store.mesh(item->mesh).positions.size();
    const gpu::Buffer& buffer = meshes.shape_buffer(store, *item);
    result.positions.resize(count);
    result.normals.resize(count);
    result.tangents.resize(store.mesh(item->mesh).tangents.size());
    buffer.read(std::span(result.positions));
    buffer.read(std::span(result.normals), count * sizeof(glm::vec3));
    if (!result.tangents.empty()) buffer.read(std::span(result.tangents), 2 * count * sizeof(glm::vec3));
    return result;
}

/// To 1e-4 of the shape's size, and of a unit vector; `apart` of the normals and tangents may be further apart (where
/// a blend of joints leaves next to nothing of a direction, rounding decides on it).
inline void expect_same(const Deformed& cpu, const Vertices& gpu, std::size_t apart = 0) {
    ASSERT_EQ(gpu.positions.size(), cpu.positions.size());
    ASSERT_EQ(gpu.tangents.size(), cpu.tangents.size());
    const float size = std::max(1e-6f, glm::length(cpu.bounds.extent()));
    std::size_t normals_apart = 0, tangents_apart = 0;
    for (std::size_t v = 0; v < cpu.positions.size(); ++v) {
        ASSERT_LT(glm::distance(gpu.positions[v], cpu.positions[v]), 1e-4f * size) << "vertex " << v;
        ASSERT_NEAR(glm::length(gpu.normals[v]), 1.0f, 1e-5f) << "vertex " << v;
        normals_apart += !(glm::distance(gpu.normals[v], cpu.normals[v]) < 1e-4f);
        if (cpu.tangents.empty()) continue;
        ASSERT_NEAR(glm::length(glm::vec3(gpu.tangents[v])), 1.0f, 1e-5f) << "vertex " << v;
        tangents_apart += !(glm::distance(gpu.tangents[v], cpu.tangents[v]) < 1e-4f);
    }
    EXPECT_LE(normals_apart, apart);
    EXPECT_LE(tangents_apart, apart);
}

inline bool inside(const geometry::Bounds& bounds, const std::vector<glm::vec3>& points) {
    const geometry::Bounds around = geometry::bounds_of(points);
    return glm::all(glm::lessThanEqual(bounds.low, around.low)) &&
           glm::all(glm::greaterThanEqual(bounds.high, around.high));
}

} // namespace hachure::test
