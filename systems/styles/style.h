#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {

namespace assets {
class JsonText;
}

/// Components, with field values, that a style puts on the entities of one kind.
struct StyleComponent {
    const TypeInfo* type; ///< of the registry that the style was read with
    FieldValues fields;   ///< the others keep their defaults
};

/// An entity of its own that a style puts below each camera.
struct StylePart {
    std::string name; ///< as Name has it
    std::vector<StyleComponent> components;
};

/// A look, as data: what every surface carries, what every picture and the camera do, what else there is in the view,
/// and where light comes from by itself. A preset file is JSON:
///
///     { "hachure_style": 1, "name": "mine", "doc": "one line",
///       "surface": { "gooch": { "b": 0.55, "y": 0.3 }, "edge_lines": { "width": 1.5 } },
///       "picture": { "picture_coat": { "show": "bands" } },
///       "camera": { "compose": { "background": [1, 1, 1] } },
///       "parts": [ { "name": "folds", "implicit_brush": { "feature": "valleys" } } ],
///       "light": { "transform": { "rotation": [0, 0, 0, 1] }, "light": { "rig": "camera" } } }
///
/// "parts" are entities below each camera, in order, for what a view has several of; they are gone when another style
/// comes. Pictures also take what "surface" says and means something on them (abstracted_lines, picture_coat); "picture" comes
/// before it. "light" is for the light of scenes that bring none (DefaultLight); others have been lit by who made them.
struct Style {
    std::string name;
    std::string doc;
    std::vector<StyleComponent> surface;
    std::vector<StyleComponent> picture; ///< all that pictures take; empty: the style is for surfaces alone
    std::vector<StyleComponent> camera;
    std::vector<StylePart> parts; ///< below each camera
    std::vector<StyleComponent> light;
};

/// A style that is built in (systems/styles/*.json).
struct BuiltInStyle {
    const char* name;
    const char* text; ///< JSON
};

/// The built-in styles, sorted by name. The build generates it.
[[nodiscard]] std::span<const BuiltInStyle> built_in_styles();

/// Reads a style; `subject` names it in errors. Throws Error for JSON that is broken, and for unknown components,
/// fields and values out of range, with line and column.
[[nodiscard]] Style parse_style(const TypeRegistry& types, std::string_view subject, std::string_view json);

/// All that is wrong with a style document, one line each, with its place.
[[nodiscard]] std::vector<std::string> style_faults(const TypeRegistry& types, const assets::JsonText& document);

/// A built-in style by its name, else the preset file of that path. Throws Error when there is neither.
[[nodiscard]] Style find_style(const TypeRegistry& types, std::string_view name_or_path);

/// Puts the style's components on every surface, picture and camera of the world. What the file of a model says of them
/// itself (components/model_extras.h) stays.
void apply_style(World& world, const TypeRegistry& types, const Style& style);

/// The same for what stands at and below one entity.
void apply_style(World& world, const Style& style, Entity root);

} // namespace hachure
