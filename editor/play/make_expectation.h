#pragma once

#include <hachure/editor/play/expectation.h>
#include <hachure/editor/play/json_object.h>
#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/scene/view.h>

#include <memory>

namespace hachure::play {

/// Where an expectation is read from, and what of the test it depends on.
struct ExpectationSource {
    const TypeRegistry& types;
    std::filesystem::path folder; ///< what paths are relative to
    Canvas size;                  ///< of the pictures
    std::int64_t frames;          ///< of the test
    const assets::JsonText& text;
    std::string pointer;
    const nlohmann::json& value;
};

/// Reads an expectation of any kind. Throws Error with line and column.
[[nodiscard]] std::unique_ptr<Expectation> make_expectation(const ExpectationSource& source);

/// What a kind of expectation is made from: its object, of which the frames have been read.
struct ExpectationParts {
    const ExpectationSource& source;
    JsonObject& object;
    FrameRange frames;
};

// One kind each.
[[nodiscard]] std::unique_ptr<Expectation> make_picture_expectation(const ExpectationParts& parts);
[[nodiscard]] std::unique_ptr<Expectation> make_aov_expectation(const ExpectationParts& parts);
[[nodiscard]] std::unique_ptr<Expectation> make_field_expectation(const ExpectationParts& parts);
[[nodiscard]] std::unique_ptr<Expectation> make_count_expectation(const ExpectationParts& parts);
[[nodiscard]] std::unique_ptr<Expectation> make_pass_expectation(const ExpectationParts& parts);
[[nodiscard]] std::unique_ptr<Expectation> make_passes_expectation(const ExpectationParts& parts);
[[nodiscard]] std::unique_ptr<Expectation> make_allocation_expectation(const ExpectationParts& parts);
[[nodiscard]] std::unique_ptr<Expectation> make_popping_expectation(const ExpectationParts& parts);
[[nodiscard]] std::unique_ptr<Expectation> make_flicker_expectation(const ExpectationParts& parts);
[[nodiscard]] std::unique_ptr<Expectation> make_time_expectation(const ExpectationParts& parts);

/// Throws Error at `pointer` when `text` is no assignment PATH=VALUE.
void check_assignment(const TypeRegistry& types, const std::string& text, const assets::JsonText& document,
                      const std::string& pointer);

/// The limits "at_least" and "at_most" of an object; at least one of them when `needed`.
struct Limits {
    std::optional<double> at_least, at_most;
};
[[nodiscard]] Limits parse_limits(JsonObject& object);

} // namespace hachure::play
