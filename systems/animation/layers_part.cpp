#include <hachure/components/animation_layers.h>
#include <hachure/systems/animation/animation_parts.h>
#include <hachure/systems/animation/part_source.h>

namespace hachure {
namespace {

using assets::JsonValue;
using nlohmann::json;

constexpr const char* layers_name = "animation_layers";
constexpr std::size_t most_layers = 64;
constexpr const char* repeat_words[] = {"once", "loop", "ping_pong"};

AnimationLayer read_layer(const JsonValue& value) {
    value.require_keys({"clip", "weight", "additive", "mask", "repeat", "speed", "offset", "time"});
    AnimationLayer layer;
    layer.clip = value.at("clip").string();
    if (const auto weight = value.find("weight")) layer.weight = static_cast<float>(weight->number(0, 1));
    if (const auto additive = value.find("additive")) layer.additive = additive->flag();
    if (const auto mask = value.find("mask")) layer.mask = mask->string();
    if (const auto repeat = value.find("repeat"))
        layer.repeat = static_cast<Repeat>(repeat->option({"once", "loop", "ping_pong"}));
    if (const auto speed = value.find("speed")) layer.speed = static_cast<float>(speed->number(-1000, 1000));
    if (const auto offset = value.find("offset")) layer.offset = static_cast<float>(offset->number(-1e6, 1e6));
    if (const auto time = value.find("time")) layer.time = time->number(0, 1e9);
    return layer;
}

json write_layers(const AnimationLayers& layers) {
    json result = json::array();
    const AnimationLayer usual;
    for (const AnimationLayer& layer : layers.layers) {
        json one{{"clip", layer.clip}};
        if (layer.weight != usual.weight) one["weight"] = shortest_number(layer.weight);
        if (layer.additive) one["additive"] = true;
        if (!layer.mask.empty()) one["mask"] = layer.mask;
        if (layer.repeat != usual.repeat) one["repeat"] = repeat_words[static_cast<std::size_t>(layer.repeat)];
        if (layer.speed != usual.speed) one["speed"] = shortest_number(layer.speed);
        if (layer.offset != usual.offset) one["offset"] = shortest_number(layer.offset);
        if (layer.time != usual.time) one["time"] = layer.time;
        result.push_back(std::move(one));
    }
    return result;
}

void add_layers(World& world, Entity entity, const ScenePartSource& source) {
    const JsonValue value(source.text, source.pointer, source.value);
    AnimationLayers layers;
    const std::size_t count = value.array_size(most_layers);
    for (std::size_t i = 0; i < count; ++i) {
        layers.layers.push_back(read_layer(value.at(i)));
        warn_of_unknown_clip(world, entity, value.at(i).at("clip"), source.warnings);
    }
    remember_source(world, entity, layers_name, source.value, write_layers(layers));
    world.add(entity, std::move(layers));
}

std::optional<json> layers_json(const World& world, Entity entity) {
    const AnimationLayers* layers = world.find<AnimationLayers>(entity);
    if (!layers) return std::nullopt;
    return as_it_was(world, entity, layers_name, write_layers(*layers));
}

const char* const layers_schema_text = R"json({
  "type": "array", "maxItems": 64, "items": {
    "type": "object", "required": ["clip"], "additionalProperties": false,
    "properties": {
      "clip": {"type": "string"},
      "weight": {"type": "number", "minimum": 0, "maximum": 1, "default": 1},
      "additive": {"type": "boolean", "default": false},
      "mask": {"type": "string", "description": "the node that it begins at"},
      "repeat": {"enum": ["once", "loop", "ping_pong"], "default": "loop"},
      "speed": {"type": "number", "minimum": -1000, "maximum": 1000, "default": 1},
      "offset": {"type": "number", "minimum": -1e6, "maximum": 1e6, "default": 0},
      "time": {"type": "number", "minimum": 0, "maximum": 1e9, "default": 0}}}
})json";

} // namespace

ScenePart animation_layers_part() {
    return {layers_name, "clips over the one that a model plays, in order", json::parse(layers_schema_text), add_layers,
            layers_json};
}

} // namespace hachure
