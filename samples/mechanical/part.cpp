#include "part.h"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <utility>

#include "solids.h"

namespace {

using namespace hachure;

constexpr double pi = glm::pi<double>();
constexpr glm::dvec3 origin(0.0), up(0.0, 1.0, 0.0), down(0.0, -1.0, 0.0);

/// A circle around the axis with a point at every segment.
Loop ring(double radius, double height) { return circle(0.0, 0.0, radius, height, segments); }

/// A plate with six holes, a fillet up to the hub, and the shaft that the gear sits on.
assets::Primitive make_flange() {
    constexpr double top = 0.24, edge = 0.035, radius = 1.0;
    Solid solid;
    solid.turn_line({radius - edge, 0.0}, {radius, edge}, {1, -1});
    solid.turn_line({radius, edge}, {radius, top - edge}, {1, 0});
    solid.turn_line({radius, top - edge}, {radius - edge, top}, {1, 1});
    constexpr double fillet = 0.1, foot = 0.58, hub = foot - fillet;
    solid.holed_face(foot, radius - edge, top, 1.0, 6, 0.775, 0.085, 10);
    solid.face(ring(radius - edge, 0.0), {}, origin, down);
    for (int i = 0; i < 6; ++i) {
        const double k = 10 + 20 * i;
        solid.hole(circle(0.775, k, 0.085, 0.06, 36), circle(0.775, k, 0.085, top, 36), polar(0.775, 0.0, k));
        solid.face(circle(0.775, k, 0.085, 0.06, 36), {}, polar(0.775, 0.06, k), up);
    }
    solid.turn_arc({foot, top + fillet}, fillet, 1.5 * pi, pi, -1.0);
    solid.turn_line({hub, top + fillet}, {hub, 0.72}, {1, 0});
    solid.turn_line({hub, 0.72}, {hub - 0.04, 0.76}, {1, 1});
    solid.turn_line({hub - 0.04, 0.76}, {0.27, 0.76}, {0, 1});
    solid.turn_line({0.27, 0.76}, {0.27, 1.4}, {1, 0});
    return solid.finish(0);
}

constexpr int teeth = 24;

/// The outline of a spur gear: root, flank, tip, flank; `inset` draws it in at the chamfered edges.
Loop gear_outline(double inset, double height) {
    Loop loop;
    constexpr double pitch = double(segments) / teeth;
    for (int tooth = 0; tooth < teeth; ++tooth) {
        const double at = pitch * tooth;
        for (const auto& [radius, turn] : {std::pair(0.70, -0.36), std::pair(0.80, -0.24), std::pair(0.86, -0.13),
                                           std::pair(0.86, 0.13), std::pair(0.80, 0.24), std::pair(0.70, 0.36)})
            loop.push_back(polar(radius - (radius > 0.75 ? inset : 0.0), height, at + pitch * turn));
    }
    return loop;
}

/// Toothed rim, a thinner web with five holes, and a boss.
assets::Primitive make_gear() {
    constexpr double low = 0.86, high = 1.14, chamfer = 0.02, web = 0.07, rim = 0.62, boss = 0.36, bore = 0.27;
    Solid solid;
    const glm::dvec3 middle(0.0, 1.0, 0.0);
    solid.wall(gear_outline(chamfer, low), gear_outline(0.0, low + chamfer), middle, 1.0);
    solid.wall(gear_outline(0.0, low + chamfer), gear_outline(0.0, high - chamfer), middle, 1.0);
    solid.wall(gear_outline(0.0, high - chamfer), gear_outline(chamfer, high), middle, 1.0);
    for (const double side : {1.0, -1.0}) {
        const double face = side > 0.0 ? high : low, inner = face - side * web;
        solid.face(gear_outline(chamfer, face), ring(rim, face), {0.0, face, 0.0}, {0.0, side, 0.0});
        solid.turn_line({rim, face}, {rim, inner}, {-1, 0});
        solid.holed_face(boss, rim, inner, side, 5, 0.49, 0.085, 0);
        solid.turn_line({boss, inner}, {boss, face}, {1, 0});
        solid.turn_line({boss, face}, {bore, face}, {0, side});
    }
    for (int i = 0; i < 5; ++i)
        solid.hole(circle(0.49, 24 * i, 0.085, low + web, 36), circle(0.49, 24 * i, 0.085, high - web, 36),
                   polar(0.49, 0.0, 24 * i));
    return solid.finish(0);
}

/// Fluted around, rounded above, with a chamfered bore.
assets::Primitive make_knob() {
    constexpr double low = 1.2, high = 1.66, radius = 0.43, round = 0.07, bore = 0.16;
    constexpr int flutes = 12, turns = 8;
    const auto outline = [](double k) {
        const double wave = 0.5 + 0.5 * std::cos(flutes * 2.0 * pi * k / segments);
        return radius - 0.05 * wave * wave;
    };
    Solid solid;
    solid.sheet(1, [&](double row, double k) { return polar(outline(k), low + row * (high - round - low), k); });
    solid.sheet(turns, [&](double row, double k) {
        const double angle = 0.5 * pi * row / turns;
        return polar(outline(k) - round * (1.0 - std::cos(angle)), high - round * (1.0 - std::sin(angle)), k);
    });
    Loop rim, foot;
    for (int k = 0; k < segments; ++k) {
        rim.push_back(
            polar(outline(k) - round * (1.0 - std::cos(0.5 * pi)), high - round * (1.0 - std::sin(0.5 * pi)), k));
        foot.push_back(polar(outline(k), low, k));
    }
    solid.face(rim, ring(bore + 0.03, high), {0.0, high, 0.0}, up);
    solid.face(foot, ring(0.27, low), {0.0, low, 0.0}, down);
    solid.turn_line({bore + 0.03, high}, {bore, high - 0.03}, {-1, 1});
    solid.turn_line({bore, high - 0.03}, {bore, 1.4}, {-1, 0});
    solid.face(ring(bore, 1.4), {}, {0.0, 1.4, 0.0}, up);
    return solid.finish(0);
}

/// A cap screw with a hexagon socket, its head standing on y = 0, on a washer.
assets::Primitive make_screw() {
    constexpr double washer = 0.02, top = 0.15, radius = 0.085, edge = 0.015, socket = 0.05;
    Solid solid;
    solid.turn_line({0.115, 0.0}, {0.115, washer}, {1, 0});
    solid.turn_line({0.115, washer}, {radius, washer}, {0, 1});
    solid.turn_line({radius, washer}, {radius, top - edge}, {1, 0});
    solid.turn_line({radius, top - edge}, {radius - edge, top}, {1, 1});
    solid.face(ring(radius - edge, top), hexagon(socket, top), {0.0, top, 0.0}, up);
    solid.wall(hexagon(socket, 0.07), hexagon(socket, top), {0.0, 0.1, 0.0}, -1.0);
    solid.face(hexagon(socket, 0.07), {}, {0.0, 0.07, 0.0}, up);
    return solid.finish(0);
}

} // namespace

assets::Model make_part() {
    assets::Model model;
    model.materials.push_back({.name = "steel", .base_color = {0.55f, 0.57f, 0.60f, 1.0f}});
    model.meshes.push_back({"flange", {make_flange()}, {}});
    model.meshes.push_back({"gear", {make_gear()}, {}});
    model.meshes.push_back({"knob", {make_knob()}, {}});
    model.meshes.push_back({"screw", {make_screw()}, {}});
    const auto add = [&](const char* name, int mesh, glm::dvec3 at) {
        model.nodes.push_back({.name = name, .translation = glm::vec3(at), .mesh = mesh});
    };
    add("flange", 0, origin);
    add("gear", 1, origin);
    add("knob", 2, origin);
    for (int i = 0; i < 6; ++i) add("screw", 3, polar(0.775, 0.24, 20.0 * i));
    assets::Scene scene{"part", {}};
    for (std::size_t i = 0; i < model.nodes.size(); ++i) scene.roots.push_back(static_cast<std::int32_t>(i));
    model.scenes.push_back(scene);
    return model;
}
