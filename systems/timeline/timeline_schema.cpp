#include <hachure/systems/timeline/timeline_schema.h>

#include <nlohmann/json.hpp>

namespace hachure {

nlohmann::json timeline_schema() {
    return nlohmann::json::parse(R"json({
  "type": "object",
  "description": "a timeline, or the file that it stands in",
  "properties": {
    "file": {"type": "string", "description": "a file with the timeline, relative to the folder of this one"},
    "hachure_timeline": {"const": 1},
    "doc": {"type": "string"},
    "duration": {"type": "number", "minimum": 0, "maximum": 1e9, "description": "seconds; the last key when absent"},
    "repeat": {"enum": ["once", "loop", "ping_pong"], "default": "once"},
    "speed": {"type": "number", "minimum": -1000, "maximum": 1000, "default": 1},
    "playing": {"type": "boolean", "default": true},
    "time": {"type": "number", "minimum": 0, "maximum": 1e9, "default": 0, "description": "seconds played already"},
    "tracks": {"type": "array", "maxItems": 100000, "items": {
      "type": "object", "required": ["target", "keys"], "additionalProperties": false,
      "properties": {
        "target": {"type": "string", "description": "path/of/names/component.field, or .x, .y, ... of it"},
        "interpolation": {"enum": ["step", "linear", "cubic", "ease_in", "ease_out", "ease_in_out"]},
        "keys": {"type": "array", "minItems": 1, "items": {"oneOf": [
          {"type": "array", "minItems": 2, "maxItems": 2, "prefixItems": [{"type": "number", "minimum": 0}]},
          {"type": "object", "required": ["t", "value"], "additionalProperties": false,
           "properties": {
             "t": {"type": "number", "minimum": 0},
             "value": {},
             "in": {"description": "slope before the key, per second"},
             "out": {"description": "slope after the key, per second"},
             "interpolation": {"enum": ["step", "linear", "cubic", "ease_in", "ease_out", "ease_in_out"]}}}]}}}}},
    "paths": {"type": "array", "maxItems": 100000, "items": {
      "type": "object", "required": ["target"], "additionalProperties": false,
      "anyOf": [{"required": ["points"]}, {"required": ["look_at"]}],
      "properties": {
        "target": {"type": "string", "description": "path of names of the entity that moves"},
        "look_at": {"oneOf": [{"type": "string"},
                              {"type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "number"}}]},
        "points": {"type": "array", "minItems": 1, "items": {
          "type": "array", "minItems": 2, "maxItems": 2, "prefixItems": [
            {"type": "number", "minimum": 0},
            {"type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "number"}}]}}}}},
    "actions": {"type": "array", "maxItems": 100000, "items": {
      "type": "object", "required": ["at"], "additionalProperties": false,
      "anyOf": [{"required": ["spawn"]}, {"required": ["destroy"]}, {"required": ["parent", "to"]},
                {"required": ["clip"]}, {"required": ["state"]}, {"required": ["camera"]}, {"required": ["event"]}],
      "properties": {
        "at": {"type": "number", "minimum": 0},
        "spawn": {"type": "string", "minLength": 1, "description": "a file, or an entity to copy"},
        "name": {"type": "string", "minLength": 1},
        "destroy": {"type": "string", "minLength": 1},
        "parent": {"type": "string", "minLength": 1, "description": "of what is spawned; or who gets a new parent"},
        "to": {"type": ["string", "null"]},
        "clip": {"type": "string"},
        "state": {"type": "object", "additionalProperties": {"type": ["number", "boolean"]}},
        "camera": {"type": "string", "minLength": 1},
        "event": {"type": "string", "minLength": 1},
        "on": {"type": "string", "minLength": 1}}}}
  },
  "additionalProperties": false
})json");
}

} // namespace hachure
