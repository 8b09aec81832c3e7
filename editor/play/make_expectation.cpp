#include <hachure/editor/assignments.h>
#include <hachure/editor/play/make_expectation.h>
#include <hachure/editor/usage_error.h>

#include <fmt/format.h>

#include <array>
#include <limits>

namespace hachure::play {
namespace {

struct Kind {
    const char* key;
    std::unique_ptr<Expectation> (*make)(const ExpectationParts&);
    bool has_frames;
    bool is_sequence; ///< looks at several frames
};

/// In this order: a buffer has a picture, too.
constexpr std::array<Kind, 10> expectation_kinds{{{"aov", &make_aov_expectation, true, false},
                                                  {"picture", &make_picture_expectation, true, false},
                                                  {"field", &make_field_expectation, true, false},
                                                  {"count", &make_count_expectation, true, false},
                                                  {"pass", &make_pass_expectation, true, false},
                                                  {"passes", &make_passes_expectation, true, false},
                                                  {"allocations", &make_allocation_expectation, true, false},
                                                  {"popping", &make_popping_expectation, true, true},
                                                  {"flicker", &make_flicker_expectation, true, true},
                                                  {"time", &make_time_expectation, false, false}}};

FrameRange parse_range(JsonObject& object, std::int64_t frames) {
    const nlohmann::json& value = object.at("frames");
    const auto end = [&](std::size_t i) {
        return value[i].is_number_integer() ? value[i].get<std::int64_t>() : std::int64_t{-1};
    };
    if (!value.is_array() || value.size() != 2 || end(0) < 0 || end(1) < end(0) || end(1) >= frames)
        object.fail("frames", fmt::format("frames is no [first, last] within 0 to {}", frames - 1));
    return {end(0), end(1)};
}

FrameRange parse_frames(JsonObject& object, std::int64_t frames) {
    if (object.has("frame") == object.has("frames"))
        object.document().fail(object.pointer(), "it takes either frame or frames to say when");
    if (object.has("frames")) return parse_range(object, frames);
    const std::int64_t frame = object.integer("frame", 0, frames - 1);
    return {frame, frame};
}

} // namespace

std::unique_ptr<Expectation> make_expectation(const ExpectationSource& source) {
    JsonObject object(source.text, source.pointer, source.value);
    const auto kind = std::ranges::find_if(expectation_kinds, [&](const Kind& k) { return object.has(k.key); });
    if (kind == expectation_kinds.end())
        source.text.fail(source.pointer, "says nothing that can be expected: picture, aov, field, count, pass, passes, "
                                         "allocations, popping, flicker or time");
    FrameRange frames;
    if (kind->has_frames) frames = parse_frames(object, source.frames);
    if (kind->is_sequence && frames.first == frames.last)
        source.text.fail(source.pointer, std::string(kind->key) + " is between frames: it takes frames, [first, last]");
    std::unique_ptr<Expectation> result = kind->make({source, object, frames});
    object.finish();
    return result;
}

void check_assignment(const TypeRegistry& types, const std::string& text, const assets::JsonText& document,
                      const std::string& pointer) {
    try {
        static_cast<void>(parse_assignments(types, std::span(&text, 1)));
    } catch (const UsageError& error) {
        document.fail(pointer, error.what());
    }
}

Limits parse_limits(JsonObject& object) {
    constexpr double largest = std::numeric_limits<double>::max();
    Limits limits;
    if (object.has("at_least")) limits.at_least = object.number("at_least", -largest, largest);
    if (object.has("at_most")) limits.at_most = object.number("at_most", -largest, largest);
    if (limits.at_least && limits.at_most && *limits.at_least > *limits.at_most)
        object.fail("at_least", "at_least is more than at_most");
    return limits;
}

} // namespace hachure::play
