#include <hachure/systems/model/bind_pointers.h>

#include <array>
#include <charconv>
#include <optional>
#include <string_view>

namespace hachure {
namespace {

/// Whose field a pointer names.
enum class Owner { camera, light, surface };

/// A pointer's text before and after the number of the thing that it means.
struct Pattern {
    std::string_view before, after;
    Owner owner;
    std::string_view component, field;
    std::uint32_t components;
};

constexpr std::string_view lights = "/extensions/KHR_lights_punctual/lights/";
constexpr std::array patterns{
    Pattern{"/cameras/", "/perspective/yfov", Owner::camera, "camera", "yfov", 1},
    Pattern{"/cameras/", "/perspective/znear", Owner::camera, "camera", "znear", 1},
    Pattern{"/cameras/", "/perspective/zfar", Owner::camera, "camera", "zfar", 1},
    Pattern{"/cameras/", "/orthographic/ymag", Owner::camera, "camera", "ymag", 1},
    Pattern{"/cameras/", "/orthographic/znear", Owner::camera, "camera", "znear", 1},
    Pattern{"/cameras/", "/orthographic/zfar", Owner::camera, "camera", "zfar", 1},
    Pattern{lights, "/color", Owner::light, "light", "color", 3},
    Pattern{lights, "/intensity", Owner::light, "light", "intensity", 1},
    Pattern{lights, "/range", Owner::light, "light", "range", 1},
    Pattern{lights, "/spot/innerConeAngle", Owner::light, "light", "inner_cone", 1},
    Pattern{lights, "/spot/outerConeAngle", Owner::light, "light", "outer_cone", 1},
    Pattern{"/nodes/", "/extensions/KHR_node_visibility/visible", Owner::surface, "surface", "visible", 1},
};

/// The number between what the pattern has before and after it.
std::optional<std::int32_t> match(const Pattern& pattern, std::string_view pointer) {
    if (!pointer.starts_with(pattern.before) || !pointer.ends_with(pattern.after)) return std::nullopt;
    if (pointer.size() <= pattern.before.size() + pattern.after.size()) return std::nullopt;
    const char* first = pointer.data() + pattern.before.size();
    const char* last = pointer.data() + pointer.size() - pattern.after.size();
    std::int32_t number = 0;
    const auto [end, error] = std::from_chars(first, last, number);
    return error == std::errc{} && end == last ? std::optional(number) : std::nullopt;
}

std::vector<Entity> entities_of(Owner owner, std::int32_t number, const PointerOwners& owners) {
    std::vector<Entity> result;
    if (owner == Owner::surface) {
        if (number >= 0 && static_cast<std::size_t>(number) < owners.surfaces.size() &&
            owners.surfaces[static_cast<std::size_t>(number)])
            result.push_back(owners.surfaces[static_cast<std::size_t>(number)]);
        return result;
    }
    const auto [first, last] = (owner == Owner::camera ? owners.cameras : owners.lights).equal_range(number);
    for (auto entry = first; entry != last; ++entry) result.push_back(entry->second);
    return result;
}

} // namespace

void bind_pointers(const animation::Clip& clip, std::uint32_t index, const PointerOwners& owners,
                   std::vector<RigPointer>& bound, std::vector<std::string>& warnings) {
    for (std::uint32_t channel = 0; channel < clip.pointers.size(); ++channel) {
        const animation::PointerChannel& source = clip.pointers[channel];
        const std::size_t before = bound.size();
        for (const Pattern& pattern : patterns) {
            const std::optional<std::int32_t> number = match(pattern, source.pointer);
            if (!number || source.components != pattern.components) continue;
            for (const Entity entity : entities_of(pattern.owner, *number, owners))
                bound.push_back({index, channel, entity, std::string(pattern.component), std::string(pattern.field)});
        }
        if (bound.size() == before)
            warnings.push_back("clip '" + clip.name + "': nothing here is meant by '" + source.pointer + "'");
    }
}

} // namespace hachure
