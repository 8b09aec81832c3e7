#include <hachure/editor/play/field_path.h>
#include <hachure/editor/play/make_expectation.h>
#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/ecs/field_text.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::play {
namespace {

FieldPath parse_path(const ExpectationParts& parts) {
    const std::string text = parts.object.text("field");
    try {
        return parse_field_path(parts.source.types, text);
    } catch (const Error& error) {
        parts.object.fail("field", error.what());
    }
}

/// A field has a value, or stays within limits.
class FieldExpectation final : public Expectation {
public:
    FieldExpectation(const ExpectationParts& parts)
        : Expectation("field", parts.source.pointer, parts.frames), text_(parts.object.text("field")),
          path_(parse_path(parts)), limits_(parse_limits(parts.object)) {
        JsonObject& object = parts.object;
        tolerance_ = object.number("tolerance", 0.0, std::numeric_limits<double>::max(), 1e-6);
        if (object.find("is")) read_wanted(object);
        const bool bounded = limits_.at_least || limits_.at_most;
        if (has_wanted_ == bounded)
            object.document().fail(object.pointer(), "a field takes either is, or at_least and at_most");
        if (bounded && element_names(*path_.field).empty()) object.fail("field", "'" + text_ + "' is no number");
        make_curves();
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::logic; }

    void look(PlayedFrame& frame) override {
        const std::vector<const void*> components = find_components(path_, frame.world(), frame.names());
        if (components.empty()) return fail(frame.number(), "nobody of that name carries '" + path_.type->name + "'");
        bool first = true;
        for (const void* component : components) {
            const FieldValue value = path_.field->get(component);
            const std::vector<double> all = selected(numbers(value));
            if (first) record(frame.number(), all);
            first = false;
            if (!holds(value, all, frame)) fail(frame.number(), "it is " + shown(value, all));
        }
    }

protected:
    [[nodiscard]] std::string what() const override {
        if (has_wanted_) return text_ + " is " + wanted_text_;
        std::string result = text_ + " is";
        if (limits_.at_least) result += fmt::format(" at least {}", *limits_.at_least);
        if (limits_.at_most) result += fmt::format("{} at most {}", limits_.at_least ? " and" : "", *limits_.at_most);
        return result;
    }

    void judge(const JudgeContext&, ExpectationResult& result) override { result.curves = curves_; }

private:
    /// What an entity is called, or null.
    void read_wanted(JsonObject& object) {
        const nlohmann::json& value = object.at("is");
        has_wanted_ = true;
        wanted_text_ = value.dump();
        if (path_.field->kind == FieldKind::entity) {
            if (!value.is_null()) wanted_entity_ = object.text("is");
        } else if (path_.element) {
            wanted_numbers_ = {
                object.number("is", -std::numeric_limits<double>::max(), std::numeric_limits<double>::max())};
        } else {
            read_whole(object, value);
        }
    }

    void read_whole(JsonObject& object, const nlohmann::json& value) {
        try {
            const FieldValues values = fields_from_json(*path_.type, {{path_.field->name, value}});
            wanted_ = values.at(0).second;
        } catch (const Error& error) {
            object.fail("is", error.what());
        }
        wanted_numbers_ = numbers(wanted_);
    }

    [[nodiscard]] std::vector<double> selected(std::vector<double> all) const {
        return path_.element ? std::vector<double>{all[*path_.element]} : std::move(all);
    }

    [[nodiscard]] bool holds(const FieldValue& value, const std::vector<double>& all, PlayedFrame& frame) const {
        if (!has_wanted_)
            return std::ranges::all_of(all, [&](double v) {
                return (!limits_.at_least || v >= *limits_.at_least - tolerance_) &&
                       (!limits_.at_most || v <= *limits_.at_most + tolerance_);
            });
        if (path_.field->kind == FieldKind::entity) {
            const Entity entity = std::get<Entity>(value);
            return wanted_entity_.empty()
                       ? entity == Entity::null
                       : std::ranges::count(frame.names().find_all(frame.world(), wanted_entity_), entity) > 0;
        }
        if (all.empty()) return value == wanted_;
        // A quaternion and its negative are the same rotation.
        return is_near(all, 1.0) ||
               (path_.field->kind == FieldKind::quaternion && !path_.element && is_near(all, -1.0));
    }

    [[nodiscard]] bool is_near(const std::vector<double>& all, double sign) const {
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!(std::abs(all[i] - sign * wanted_numbers_[i]) <= tolerance_)) return false;
        return true;
    }

    [[nodiscard]] std::string shown(const FieldValue& value, const std::vector<double>& all) const {
        return path_.element ? fmt::format("{:.9g}", all[0]) : format_field(*path_.field, value);
    }

    void make_curves() {
        std::vector<std::string> names = element_names(*path_.field);
        if (path_.element) names = {""};
        for (std::size_t i = 0; i < names.size(); ++i) {
            Curve curve{text_ + names[i], path_.field->unit, 0, {}, limits_.at_least, limits_.at_most};
            if (has_wanted_ && i < wanted_numbers_.size()) {
                curve.at_least = wanted_numbers_[i] - tolerance_;
                curve.at_most = wanted_numbers_[i] + tolerance_;
            }
            curves_.push_back(std::move(curve));
        }
    }

    void record(std::int64_t frame, const std::vector<double>& all) {
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            if (curves_[i].values.empty()) curves_[i].first_frame = frame;
            curves_[i].values.push_back(all[i]);
        }
    }

    std::string text_;
    FieldPath path_;
    Limits limits_;
    double tolerance_ = 0.0;
    bool has_wanted_ = false;
    FieldValue wanted_;
    std::vector<double> wanted_numbers_;
    std::string wanted_entity_, wanted_text_;
    std::vector<Curve> curves_;
};

} // namespace

std::unique_ptr<Expectation> make_field_expectation(const ExpectationParts& parts) {
    return std::make_unique<FieldExpectation>(parts);
}

} // namespace hachure::play
