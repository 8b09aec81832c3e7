// What a program outside the house does: a world, a capability, a sphere, a picture in memory.

#include <hachure/components/gooch.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/compose/compose.h>
#include <hachure/systems/gooch/gooch.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/surface/surface.h>
#include <hachure/systems/transform/transform.h>

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

constexpr int size = 65; // odd, so that one pixel is the middle

void add_sphere(hachure::World& world) {
    const hachure::geometry::Shape shape = hachure::geometry::icosphere(1.0, 5);
    hachure::SurfaceMesh mesh;
    mesh.positions = shape.positions;
    mesh.normals = shape.normals;
    mesh.indices = shape.indices;
    mesh.submeshes.push_back({0, static_cast<std::uint32_t>(shape.indices.size()), {}});
    const std::uint32_t index = world.resource_mutable<hachure::MeshStore>().add(mesh);
    const hachure::Entity entity = world.create();
    world.add(entity, hachure::Transform{});
    world.add(entity, hachure::Surface{index});
    world.add(entity, hachure::Gooch{.highlight = 0.0f});
    hachure::spawn_framing_camera(world, shape.positions, {size, size});
    hachure::spawn_default_light(world);
}

int encode(double linear) {
    const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return static_cast<int>(std::lround(255.0 * encoded));
}

bool is_near(const std::uint8_t* pixel, const int (&expected)[3], int tolerance) {
    std::printf("%d %d %d, expected %d %d %d\n", pixel[0], pixel[1], pixel[2], expected[0], expected[1], expected[2]);
    for (int i = 0; i < 3; ++i)
        if (std::abs(pixel[i] - expected[i]) > tolerance) return false;
    return true;
}

/// The light is perpendicular to the gaze, so in the middle l.n = 0: halfway between the tones (0, 0, b) + alpha k_d
/// and (y, y, 0) + beta k_d of a white object.
bool run() {
    const auto context =
        hachure::gpu::make_context({.backend = hachure::gpu::Backend::osmesa, .width = size, .height = size});
    hachure::App app;
    hachure::register_transform(app);
    hachure::register_camera(app);
    hachure::register_light(app);
    hachure::register_surface(app);
    hachure::register_gooch(app);
    hachure::register_compose(app);
    hachure::Renderer renderer(app, *context);
    app.world().set_resource(hachure::Canvas{size, size});
    add_sphere(app.world());
    renderer.render_frame();
    const hachure::assets::Image picture = renderer.read_picture();

    const hachure::Gooch gooch;
    const double object = 0.5 * (gooch.alpha + gooch.beta);
    const int middle[3]{encode(0.5 * gooch.y + object), encode(0.5 * gooch.y + object), encode(0.5 * gooch.b + object)};
    const int background[3]{255, 255, 255};
    const std::size_t center = static_cast<std::size_t>(size / 2 * size + size / 2) * 3;
    return is_near(picture.u8() + center, middle, 4) && is_near(picture.u8(), background, 0);
}

} // namespace

int main() {
    try {
        return run() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "consumer: %s\n", error.what());
        return 1;
    }
}
