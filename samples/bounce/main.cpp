// Balls in a box: components, a resource, two systems, and a query. README.md beside this file says more.

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/ecs/time.h>

#include <glm/glm.hpp>
#include <unistd.h>

#include <cstdio>
#include <string>

using namespace hachure;
void draw(const World& world);

// [readme]
struct Position {
    glm::vec2 at;
};
struct Velocity {
    glm::vec2 per_second;
};
struct Box {
    glm::vec2 size;
};

void move(Query<Position, const Velocity> moving, const Time& time) {
    for (auto [entity, position, velocity] : moving) position.at += velocity.per_second * float(time.delta);
}

void bounce(Query<Position, Velocity> moving, const Box& box) {
    for (auto [entity, position, velocity] : moving) {
        const glm::vec2 wall = glm::clamp(position.at, glm::vec2(0.0f), box.size);
        velocity.per_second *= glm::mix(glm::vec2(1.0f), glm::vec2(-1.0f), glm::notEqual(position.at, wall));
        position.at = 2.0f * wall - position.at;
    }
}

int main() {
    App app;
    app.world().set_resource(Box{{62.0f, 20.0f}});
    for (float i = 0.0f; i < 90.0f; ++i)
        app.world().create_with(Position{{31.0f, 10.0f}}, Velocity{{24.0f * glm::cos(i), 12.0f * glm::sin(i)}});
    app.add_system(Stage::script, "move", move);
    app.add_system(Stage::script, "bounce", bounce).after("move");
    for (int frame = 0; frame < 100; ++frame) {
        app.run_frame(1.0 / 30.0);
        if (::isatty(STDOUT_FILENO) || frame == 99) draw(app.world());
    }
}
// [/readme]

void draw(const World& world) {
    const std::string edge = "+" + std::string(63, '-') + "+\n";
    std::string rows = edge;
    for (int i = 0; i < 21; ++i) rows += "|" + std::string(63, ' ') + "|\n";
    for (auto [entity, position] : world.query<const Position>())
        rows[66 * (21 - int(position.at.y + 0.5f)) + int(position.at.x + 0.5f) + 1] = 'o';
    std::printf("%s%s%s", ::isatty(STDOUT_FILENO) ? "\033[H\033[J" : "", rows.c_str(), edge.c_str());
    ::usleep(33'000);
}
