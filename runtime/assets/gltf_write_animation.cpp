#include <hachure/runtime/assets/gltf_writer.h>

#include <string>
#include <unordered_map>
#include <utility>

namespace hachure::assets {
namespace {

using nlohmann::json;

const char* path_name(AnimationPath path) {
    static constexpr const char* names[] = {"translation", "rotation", "scale", "weights", "pointer"};
    return names[static_cast<std::size_t>(path)];
}

const char* interpolation_name(Interpolation interpolation) {
    static constexpr const char* names[] = {"STEP", "LINEAR", "CUBICSPLINE"};
    return names[static_cast<std::size_t>(interpolation)];
}

/// Weights are scalars, whatever number of them a key has (glTF 2.0, section 3.11).
std::size_t width_of(const AnimationChannel& channel) {
    return channel.path == AnimationPath::weights ? 1 : static_cast<std::size_t>(channel.components);
}

json target_json(GltfWriter& writer, const AnimationChannel& channel) {
    json target{{"path", path_name(channel.path)}};
    if (channel.node >= 0) target["node"] = channel.node;
    if (channel.path != AnimationPath::pointer) return target;
    writer.extensions.insert("KHR_animation_pointer");
    target["extensions"]["KHR_animation_pointer"]["pointer"] = channel.pointer;
    return target;
}

/// Weights of a mesh that is not written move nothing.
bool moves_something(const GltfWriter& writer, const AnimationChannel& channel) {
    if (channel.path != AnimationPath::weights || channel.node < 0) return true;
    const std::int32_t mesh = writer.model.nodes[static_cast<std::size_t>(channel.node)].mesh;
    return mesh >= 0 && writer.mesh_places[static_cast<std::size_t>(mesh)] >= 0;
}

json animation_json(GltfWriter& writer, const Animation& animation) {
    json channels = json::array(), samplers = json::array();
    std::unordered_map<std::string, std::size_t> known;
    for (const AnimationChannel& channel : animation.channels) {
        if (!moves_something(writer, channel)) continue;
        json sampler{{"input", writer.data.scalars(channel.times, true)},
                     {"output", writer.data.groups(channel.values, width_of(channel))},
                     {"interpolation", interpolation_name(channel.interpolation)}};
        const auto [entry, fresh] = known.try_emplace(sampler.dump(), samplers.size());
        if (fresh) samplers.push_back(std::move(sampler));
        channels.push_back({{"sampler", entry->second}, {"target", target_json(writer, channel)}});
    }
    json result{{"channels", std::move(channels)}, {"samplers", std::move(samplers)}};
    if (!animation.name.empty()) result["name"] = animation.name;
    return result;
}

} // namespace

void write_animations(GltfWriter& writer) {
    json animations = json::array();
    for (const Animation& animation : writer.model.animations)
        // One without channels is no glTF; nothing would move.
        if (json written = animation_json(writer, animation); !written.at("channels").empty())
            animations.push_back(std::move(written));
    put_array(writer, "animations", std::move(animations));
}

} // namespace hachure::assets
