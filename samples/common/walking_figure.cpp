#include <hachure/components/animation.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/samples/common/lay_figure.h>
#include <hachure/samples/common/walking_figure.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cctype>
#include <vector>

namespace samples {

using namespace hachure;

namespace {

bool walks(const std::string& clip) {
    std::string lower = clip;
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower.find("walk") != std::string::npos;
}

float height_of(const std::vector<glm::vec3>& points) {
    const auto [low, high] = std::ranges::minmax(points, {}, &glm::vec3::y);
    return high.y - low.y;
}

} // namespace

SpawnedModel spawn_walking_figure(World& world, const std::string& file, float height, float girth) {
    SpawnedModel model = spawn_model(world, file.empty() ? lay_figure({height, girth}) : assets::read_model(file));
    if (model.points.empty()) throw Error(file, "has nothing to draw");
    const float drawn = height_of(model.points);
    if (!(drawn > 0.0f)) throw Error(file, "is flat: it has no height to scale");
    if (!model.clips.empty()) {
        const auto clip = std::ranges::find_if(model.clips, walks);
        world.add(model.root, Animation{.clip = clip == model.clips.end() ? model.clips.front() : *clip});
    }
    world.get_mutable<Transform>(model.root).scale = glm::vec3(height / drawn);
    return model;
}

} // namespace samples
