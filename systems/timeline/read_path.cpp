#include <hachure/systems/timeline/read_timeline.h>
#include <hachure/systems/timeline/timeline_reading.h>

#include <fmt/format.h>

#include <limits>

namespace hachure {
namespace {

using assets::JsonValue;

glm::dvec3 read_place(const JsonValue& value) {
    if (value.array_size(3) != 3) value.fail("a place is [x, y, z]");
    constexpr double most = std::numeric_limits<float>::max();
    glm::dvec3 place;
    for (int i = 0; i < 3; ++i) place[i] = value.at(static_cast<std::size_t>(i)).number(-most, most);
    return place;
}

animation::SmoothPath read_points(TimelineReading& reading, const JsonValue& value) {
    const std::size_t count = value.array_size(most_timeline_keys);
    if (count == 0) value.fail("a path has at least one point");
    count_keys(reading, value, count);
    std::vector<animation::PathPoint> points;
    for (std::size_t i = 0; i < count; ++i) {
        const JsonValue point = value.at(i);
        if (point.array_size(2) != 2) point.fail("a point of a path is [time, [x, y, z]]");
        const double time = read_time(reading, point.at(0));
        if (i > 0 && time <= points.back().time)
            point.at(0).fail(
                fmt::format("the point at {} s does not come after the one at {} s", time, points.back().time));
        points.push_back({time, read_place(point.at(1))});
    }
    return animation::make_path(points);
}

} // namespace

void read_path(TimelineReading& reading, const JsonValue& value) {
    value.require_keys({"target", "look_at", "points"});
    const JsonValue target = value.at("target");
    TimelinePath path;
    path.target = reading.target(target.string());
    const auto points = value.find("points");
    const auto look_at = value.find("look_at");
    if (!points && !look_at) value.fail("a path has points, or something to look at");
    const auto claim = [&](const char* field) {
        if (!reading.moved.emplace(path.target, field, -1).second)
            target.fail(
                fmt::format("a track or another path moves {} of {}", field, assets::in_quotes(target.string())));
    };
    if (points) {
        claim("transform.translation");
        path.path = read_points(reading, *points);
    }
    if (look_at) {
        claim("transform.rotation");
        if (look_at->json().is_string())
            path.look_at = reading.target(look_at->string());
        else
            path.look_at_place = glm::vec3(read_place(*look_at));
    }
    reading.document.paths.push_back(std::move(path));
}

} // namespace hachure
