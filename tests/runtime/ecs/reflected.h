#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <cstdint>
#include <string>

/// A component with a field of every kind, and a tag.
namespace hachure::test {

enum class Lens { perspective, orthographic, fisheye };

struct Everything {
    bool on = true;
    std::int32_t small = -3;
    std::uint32_t count = 4;
    std::int64_t big = -5'000'000'000;
    std::uint64_t seed = 18'446'744'073'709'551'615u;
    float ratio = 0.1f;
    double exact = 0.1;
    glm::vec2 offset{1, 2};
    glm::vec3 direction{0, 0, 1};
    glm::vec4 plane{0, 1, 0, 2};
    glm::quat rotation{1, 0, 0, 0};
    glm::vec3 paint{1, 0.5f, 0};
    glm::vec4 glaze{1, 1, 1, 0.5f};
    std::string title = "untitled";
    Lens lens = Lens::orthographic;
    Entity target;
};

inline void reflect(TypeBuilder<Everything>& type) {
    type.name("everything").doc("One of each.");
    type.field("on", &Everything::on).doc("a switch");
    type.field("small", &Everything::small).range(-10, 10);
    type.field("count", &Everything::count);
    type.field("big", &Everything::big);
    type.field("seed", &Everything::seed);
    type.field("ratio", &Everything::ratio).range(0, 0.1).doc("a share").unit("m");
    type.field("exact", &Everything::exact).range(0.1, 1);
    type.field("offset", &Everything::offset).unit("px");
    type.field("direction", &Everything::direction).range(-1, 1);
    type.field("plane", &Everything::plane);
    type.field("rotation", &Everything::rotation);
    type.field("paint", &Everything::paint).color().range(0, 1);
    type.field("glaze", &Everything::glaze).color();
    type.field("title", &Everything::title);
    type.field("lens", &Everything::lens).options({"perspective", "orthographic", "fisheye"});
    type.field("target", &Everything::target);
}

struct Marker {};

inline void reflect(TypeBuilder<Marker>& type) { type.name("marker").doc("Marks."); }

} // namespace hachure::test
