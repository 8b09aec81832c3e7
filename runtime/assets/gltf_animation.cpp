#include <hachure/runtime/assets/gltf_numbers.h>
#include <hachure/runtime/assets/gltf_reader.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>

namespace hachure::assets {
namespace {

AnimationPath path_of(const std::string& name) {
    if (name == "translation") return AnimationPath::translation;
    if (name == "rotation") return AnimationPath::rotation;
    if (name == "scale") return AnimationPath::scale;
    return name == "weights" ? AnimationPath::weights : AnimationPath::pointer;
}

Interpolation interpolation_of(const std::string& name) {
    if (name == "STEP") return Interpolation::step;
    return name == "CUBICSPLINE" ? Interpolation::cubic_spline : Interpolation::linear;
}

/// Reads the channels of one animation.
class AnimationReader {
public:
    AnimationReader(const GltfReader& reader, const Model& model, std::size_t index)
        : reader_(reader), model_(model), source_(reader.document.model->animations[index]), index_(index) {}

    Animation read() {
        Animation animation;
        animation.name = source_.name;
        for (std::size_t i = 0; i < source_.channels.size(); ++i) {
            std::optional<AnimationChannel> channel = read_channel(i);
            if (!channel) continue;
            animation.duration =
                std::max(animation.duration, *std::max_element(channel->times.begin(), channel->times.end()));
            animation.channels.push_back(std::move(*channel));
        }
        return animation;
    }

private:
    std::optional<AnimationChannel> read_channel(std::size_t index) {
        const tinygltf::AnimationChannel& source = source_.channels[index];
        const std::string where = fmt::format("/animations/{}/channels/{}", index_, index);
        AnimationChannel channel;
        channel.path = path_of(source.target_path);
        if (!read_target(source, channel, where)) return std::nullopt;

        const auto& sampler = source_.samplers[static_cast<std::size_t>(source.sampler)];
        channel.interpolation = interpolation_of(sampler.interpolation);
        const AccessorShape times = reader_.accessors.shape(sampler.input);
        require(times.is_vector(1), "key times must be scalars", sampler.input);
        if (times.count == 0) {
            reader_.warnings.add("animation channels without keys are skipped", where);
            return std::nullopt;
        }
        channel.components = components_per_key(channel, times.count, sampler.output);
        channel.times = reader_.accessors.floats(sampler.input);
        channel.values = reader_.accessors.floats(sampler.output);
        require(all_finite(channel.times), "has a key time that is not finite", sampler.input);
        require(all_finite(channel.values), "has a key value that is not finite", sampler.output);
        return channel;
    }

    // Who moves; false when nobody does.
    bool read_target(const tinygltf::AnimationChannel& source, AnimationChannel& channel, const std::string& where) {
        if (channel.path == AnimationPath::pointer) {
            const auto extension = source.target_extensions.find("KHR_animation_pointer");
            if (extension == source.target_extensions.end()) {
                reader_.warnings.add("animation channels without a target are skipped", where);
                return false;
            }
            channel.pointer = extension->second.Get("pointer").Get<std::string>();
            return true;
        }
        channel.node = source.target_node;
        if (channel.node >= 0) return true;
        reader_.warnings.add("animation channels without a target are skipped", where);
        return false;
    }

    // Checks that the output has as many values as its keys need (glTF 2.0, section 3.11).
    std::int32_t components_per_key(const AnimationChannel& channel, std::size_t keys, int output) const {
        const AccessorShape shape = reader_.accessors.shape(output);
        const std::size_t keys_of_values = keys * (channel.interpolation == Interpolation::cubic_spline ? 3 : 1);
        const std::size_t values = shape.count * shape.components();
        const std::size_t components = values / keys_of_values;
        require(components > 0 && components * keys_of_values == values,
                fmt::format("has {} values for {} keys", values, keys), output);
        switch (channel.path) {
        case AnimationPath::translation:
        case AnimationPath::scale:
            require(shape.is_vector(3) && components == 3, "must be one VEC3 per key", output);
            break;
        case AnimationPath::rotation:
            require(shape.is_vector(4) && components == 4, "must be one VEC4 per key", output);
            break;
        case AnimationPath::weights:
            require(shape.is_vector(1) && components == morph_targets(channel.node),
                    "must be one scalar per key and morph target", output);
            break;
        case AnimationPath::pointer:
            break;
        }
        return static_cast<std::int32_t>(components);
    }

    [[nodiscard]] std::size_t morph_targets(std::int32_t node) const {
        const int mesh = model_.nodes[static_cast<std::size_t>(node)].mesh;
        if (mesh < 0) return 0;
        const auto& primitives = reader_.document.model->meshes[static_cast<std::size_t>(mesh)].primitives;
        return primitives.empty() ? 0 : primitives.front().targets.size();
    }

    void require(bool condition, std::string_view fault, int accessor) const {
        if (!condition) reader_.document.fail(fault, accessor_pointer(accessor));
    }

    const GltfReader& reader_;
    const Model& model_;
    const tinygltf::Animation& source_;
    std::size_t index_;
};

} // namespace

void read_animations(const GltfReader& reader, Model& model) {
    for (std::size_t i = 0; i < reader.document.model->animations.size(); ++i)
        model.animations.push_back(AnimationReader(reader, model, i).read());
}

} // namespace hachure::assets
