#pragma once

#include <hachure/components/camera.h>
#include <hachure/components/name.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/compose/compose.h>
#include <hachure/systems/edge_lines/edge_lines.h>
#include <hachure/systems/gooch/gooch.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/surface/surface.h>
#include <hachure/systems/transform/transform.h>

#include <map>
#include <string>
#include <utility>

namespace hachure::test {

/// A mesh with one submesh of that material.
inline SurfaceMesh surface_mesh(const geometry::Shape& shape, const SurfaceMaterial& material = {}) {
    SurfaceMesh mesh;
    mesh.name = "shape";
    mesh.positions = shape.positions;
    mesh.normals = shape.normals;
    mesh.texcoords = shape.texcoords;
    mesh.indices = shape.indices;
    mesh.submeshes = {{0, static_cast<std::uint32_t>(shape.indices.size()), material}};
    return mesh;
}

/// A world with everything that draws models, on a context that must be current and outlive it.
class DrawnScene {
public:
    /// `capabilities` registers those that it has.
    DrawnScene(gpu::Context& context, Canvas canvas, void (*capabilities)(App&) = register_capabilities)
        : renderer_(app_, context) {
        capabilities(app_);
        world().set_resource(canvas);
    }

    [[nodiscard]] App& app() { return app_; }
    [[nodiscard]] World& world() { return app_.world(); }
    [[nodiscard]] Renderer& renderer() { return renderer_; }

    Entity add(SurfaceMesh mesh, const Transform& transform = {}) {
        const std::uint32_t index = world().resource_mutable<MeshStore>().add(std::move(mesh));
        return world().create_with(transform, Surface{index});
    }
    Entity add(const Camera& camera, const Transform& transform) { return world().create_with(transform, camera); }

    assets::Image draw() {
        renderer_.render_frame();
        return renderer_.read_picture();
    }

    /// What became of each pass of a new frame, by name.
    std::map<std::string, gpu::PassState> draw_passes() {
        renderer_.render_frame();
        std::map<std::string, gpu::PassState> states;
        for (const gpu::PassStats& pass : renderer_.pass_stats()) states[pass.name] = pass.state;
        return states;
    }

private:
    App app_;
    Renderer renderer_;
};

} // namespace hachure::test
