#include <hachure/systems/timeline/key_values.h>
#include <hachure/systems/timeline/read_timeline.h>
#include <hachure/systems/timeline/timeline_reading.h>
#include <hachure/systems/timeline/track_writer.h>

#include <fmt/format.h>

#include <string_view>

namespace hachure {
namespace {

using animation::KeyCurve;
using assets::in_quotes;
using assets::JsonValue;

/// What a track moves, as "Fox/transform.translation.y" says it.
struct MovedField {
    std::string entity;
    const TypeInfo* type = nullptr;
    const FieldInfo* field = nullptr;
    std::int32_t element = -1;
};

std::int32_t read_element(const FieldInfo& field, std::string_view name, const JsonValue& value) {
    if (field.kind == FieldKind::quaternion) value.fail("the elements of a rotation can't be moved one by one");
    const int count = field.kind == FieldKind::real ? 0 : numbers_of(field);
    const std::string_view letters = field.kind == FieldKind::color ? "rgba" : "xyzw";
    const std::size_t at = name.size() == 1 ? letters.find(name) : letters.npos;
    if (at == letters.npos || at >= static_cast<std::size_t>(count))
        value.fail(fmt::format("field {} has no element {}", in_quotes(field.path), in_quotes(name)));
    return static_cast<std::int32_t>(at);
}

/// Names of entities may hold dots and slashes; those of components and fields have none.
MovedField read_target(const TypeRegistry& types, const JsonValue& value) {
    const std::string_view path = value.string();
    const std::size_t slash = path.rfind('/');
    const std::string_view rest = path.substr(slash == path.npos ? 0 : slash + 1);
    const std::size_t dot = rest.find('.');
    if (dot == rest.npos) value.fail(fmt::format("{} names no field, as \"component.field\" does", in_quotes(path)));
    const std::string_view component = rest.substr(0, dot);
    std::string_view field = rest.substr(dot + 1);
    const std::size_t second = field.find('.');
    const std::string_view element = second == field.npos ? std::string_view() : field.substr(second + 1);
    field = field.substr(0, second);
    MovedField moved{std::string(slash == path.npos ? std::string_view() : path.substr(0, slash)),
                     types.find(component)};
    if (!moved.type) value.fail(fmt::format("there is no component {}", in_quotes(component)));
    moved.field = moved.type->field(field);
    if (!moved.field) value.fail(fmt::format("component \"{}\" has no field {}", component, in_quotes(field)));
    if (second != rest.npos && rest.find('.', dot + 1) != rest.npos)
        moved.element = read_element(*moved.field, element, value);
    return moved;
}

KeyCurve read_curve(const FieldInfo& field, const JsonValue& value) {
    const auto curve =
        static_cast<KeyCurve>(value.option({"step", "linear", "cubic", "ease_in", "ease_out", "ease_in_out"}));
    if (numbers_of(field) == 0 && curve != KeyCurve::step)
        value.fail(fmt::format("a value of kind {} changes in steps, not {}", to_string(field.kind), value.string()));
    return curve;
}

/// The keys of one track.
class KeyReader {
public:
    KeyReader(TimelineReading& reading, const MovedField& moved, KeyCurve curve)
        : reading_(reading), moved_(moved), curve_(curve), count_(moved.element >= 0 ? 1 : numbers_of(*moved.field)) {}

    std::vector<animation::TrackKey> keys;
    std::vector<TimelineChoice> choices;

    /// `[time, value]` or an object.
    void read(const JsonValue& value) {
        const bool object = value.json().is_object();
        if (object)
            value.require_keys({"t", "value", "in", "out", "interpolation"});
        else if (!value.json().is_array() || value.json().size() != 2)
            value.fail("a key is [time, value] or an object with \"t\" and \"value\"");
        const JsonValue time = object ? value.at("t") : value.at(0);
        animation::TrackKey key{read_time(reading_, time), glm::dvec4(0.0), curve_, {}, {}};
        if (!keys.empty() && key.time <= keys.back().time)
            time.fail(fmt::format("the key at {} s does not come after the one at {} s", key.time, keys.back().time));
        if (object) read_shape(value, key);
        read_value(object ? value.at("value") : value.at(1), key);
        keys.push_back(key);
    }

private:
    void read_shape(const JsonValue& value, animation::TrackKey& key) {
        if (const auto curve = value.find("interpolation")) key.curve = read_curve(*moved_.field, *curve);
        const bool curved = key.curve == KeyCurve::cubic || (!keys.empty() && keys.back().curve == KeyCurve::cubic);
        const auto tangent = [&](std::string_view name) -> std::optional<glm::dvec4> {
            const auto given = value.find(name);
            if (!given) return std::nullopt;
            if (!curved) given->fail("tangents are for cubic interpolation");
            return read_key_tangent(count_, *given);
        };
        key.in = tangent("in");
        key.out = tangent("out");
    }

    void read_value(const JsonValue& value, animation::TrackKey& key) {
        const FieldInfo& field = *moved_.field;
        if (count_ > 0) {
            key.value = read_key_numbers(field, moved_.element, value);
            return;
        }
        key.value.x = static_cast<double>(choices.size());
        if (field.kind != FieldKind::entity) {
            choices.push_back({read_key_choice(field, value)});
        } else if (value.json().is_null()) {
            choices.push_back({Entity::null});
        } else {
            choices.push_back({Entity::null, reading_.target(value.string())});
        }
    }

    TimelineReading& reading_;
    const MovedField& moved_;
    KeyCurve curve_;
    int count_; ///< numbers of a value; 0 when it is taken in steps
};

} // namespace

void read_track(TimelineReading& reading, const JsonValue& value) {
    value.require_keys({"target", "interpolation", "keys"});
    const JsonValue target = value.at("target");
    const MovedField moved = read_target(reading.types, target);
    const std::uint32_t entity = reading.target(moved.entity);
    if (!reading.moved.emplace(entity, moved.field->path, moved.element).second)
        target.fail(fmt::format("two tracks move {}", in_quotes(target.string())));
    const bool steps = numbers_of(*moved.field) == 0;
    const auto given = value.find("interpolation");
    KeyReader reader(reading, moved,
                     given   ? read_curve(*moved.field, *given)
                     : steps ? KeyCurve::step
                             : KeyCurve::linear);
    const JsonValue keys = value.at("keys");
    const std::size_t count = keys.array_size(most_timeline_keys);
    if (count == 0) keys.fail("a track has at least one key");
    count_keys(reading, keys, count);
    for (std::size_t i = 0; i < count; ++i) reader.read(keys.at(i));
    const bool turns = moved.field->kind == FieldKind::quaternion;
    add_track(reading.document.keys,
              steps   ? animation::TrackKind::choice
              : turns ? animation::TrackKind::rotation
                      : animation::TrackKind::numbers,
              reader.keys);
    reading.document.tracks.push_back(
        {entity, moved.type->name, moved.field->name, moved.element, std::move(reader.choices)});
}

} // namespace hachure
