#include <hachure/runtime/assets/image_layers.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>

namespace hachure::assets {
namespace {

using Names = std::initializer_list<std::string_view>;
using Channels = std::vector<ImageChannel>;

constexpr std::array color_layers{"combined", "rgba", "rgb", "beauty", "color", "colour", "image"};
constexpr std::array normal_layers{"n", "normal", "normals", "nn", "shading_normal"};
constexpr std::array depth_layers{"depth", "z", "zdepth"};

/// The channels of a part that have all but the last piece of their names in common.
struct Group {
    int part = 0;
    std::string path;                                                  ///< those pieces, in lower case
    std::string layer;                                                 ///< the last of them; empty: no layer
    std::vector<std::pair<std::string, const ImageChannel*>> channels; ///< by the last piece, in lower case
};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

/// "a.b" and "c" of "a.b.c".
std::pair<std::string, std::string> split_last(const std::string& text) {
    const std::size_t dot = text.rfind('.');
    if (dot == text.npos) return {"", text};
    return {text.substr(0, dot), text.substr(dot + 1)};
}

std::vector<Group> group(std::span<const ImageChannel> channels) {
    std::vector<Group> groups;
    for (const ImageChannel& channel : channels) {
        const auto [path, last] = split_last(lower(channel.name));
        auto found = std::ranges::find_if(
            groups, [&, &path = path](const Group& one) { return one.part == channel.part && one.path == path; });
        if (found == groups.end()) {
            groups.push_back({channel.part, path, split_last(path).second, {}});
            found = groups.end() - 1;
        }
        found->channels.emplace_back(last, &channel);
    }
    return groups;
}

const ImageChannel* find(const Group& group, Names names) {
    for (const std::string_view name : names)
        for (const auto& [last, channel] : group.channels)
            if (last == name) return channel;
    return nullptr;
}

/// All of those channels, or none.
Channels take(std::initializer_list<const ImageChannel*> channels) {
    Channels result;
    for (const ImageChannel* channel : channels) {
        if (!channel) return {};
        result.push_back(*channel);
    }
    return result;
}

Channels rgb(const Group& group) {
    return take({find(group, {"r", "red"}), find(group, {"g", "green"}), find(group, {"b", "blue"})});
}

Channels with_alpha(Channels channels, const Group& group) {
    const ImageChannel* alpha = find(group, {"a", "alpha"});
    if (!channels.empty() && alpha) channels.push_back(*alpha);
    return channels;
}

Channels colors(const Group& group) { return with_alpha(rgb(group), group); }
Channels greys(const Group& group) { return with_alpha(take({find(group, {"y"})}), group); }

Channels normals(const Group& group) {
    const Channels xyz = take({find(group, {"x"}), find(group, {"y"}), find(group, {"z"})});
    return xyz.empty() ? rgb(group) : xyz;
}

Channels depths(const Group& group) { return take({find(group, {"z", "v", "r", "y"})}); }
Channels only_z(const Group& group) { return take({find(group, {"z"})}); }
Channels named_depth(const Group& group) { return take({find(group, {"depth"})}); }

/// What `take` finds in the first group of that layer in which it finds anything.
template <class Take> Channels of_layer(std::span<const Group> groups, std::string_view layer, Take take) {
    for (const Group& group : groups)
        if (group.layer == layer)
            if (Channels found = take(group); !found.empty()) return found;
    return {};
}

template <class Layers, class Take> Channels of_layers(std::span<const Group> groups, const Layers& layers, Take take) {
    for (const char* layer : layers)
        if (Channels found = of_layer(groups, layer, take); !found.empty()) return found;
    return {};
}

/// Beside the colour's channels: some renderers put Z into the layer of the beauty pass.
Channels depth_beside(std::span<const Group> groups, const Channels& color) {
    for (const Group& group : groups)
        for (const auto& [last, channel] : group.channels)
            if (!color.empty() && *channel == color.front()) return only_z(group);
    return {};
}

bool has(const Channels& channels, const ImageChannel& channel) {
    return std::ranges::find(channels, channel) != channels.end();
}

/// R, G, B of any layer that is not the normal's, nor another of its kind.
Channels any_colors(std::span<const Group> groups) {
    const auto is_one_of = [](const auto& layers, const std::string& layer) {
        return std::ranges::find(layers, layer) != layers.end();
    };
    for (const Group& group : groups)
        if (!is_one_of(normal_layers, group.layer) && !is_one_of(depth_layers, group.layer))
            if (Channels found = colors(group); !found.empty()) return found;
    return {};
}

Channels first_left(std::span<const ImageChannel> channels, const ImageLayers& taken) {
    Channels result;
    for (const ImageChannel& channel : channels) {
        if (has(taken.normal, channel) || has(taken.depth, channel)) continue;
        if (result.size() < 4 && (result.empty() || result.front().part == channel.part)) result.push_back(channel);
    }
    return result;
}

} // namespace

ImageLayers find_layers(std::span<const ImageChannel> channels) {
    const std::vector<Group> groups = group(channels);
    ImageLayers layers;
    layers.color = of_layer(groups, "", colors);
    if (layers.color.empty()) layers.color = of_layers(groups, color_layers, colors);
    if (layers.color.empty()) layers.color = of_layer(groups, "", greys);
    if (layers.color.empty()) layers.color = any_colors(groups);
    layers.normal = of_layers(groups, normal_layers, normals);
    layers.depth = of_layer(groups, "", only_z);
    if (layers.depth.empty()) layers.depth = of_layers(groups, depth_layers, depths);
    if (layers.depth.empty()) layers.depth = depth_beside(groups, layers.color);
    if (layers.depth.empty()) layers.depth = of_layer(groups, "", named_depth);
    if (layers.color.empty()) layers.color = first_left(channels, layers);
    return layers;
}

} // namespace hachure::assets
