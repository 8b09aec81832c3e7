#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/field_info.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>
#include <utility>

namespace hachure {
namespace {

std::string outside(const FieldInfo& field, auto number) {
    return fmt::format("{} is outside [{}, {}]", number, field.range->min, field.range->max);
}

std::string integer_fault(const FieldInfo& field, std::integral auto number) {
    const bool fits = field.bits == 64 || (std::is_signed_v<decltype(number)> ? std::in_range<std::int32_t>(number)
                                                                              : std::in_range<std::uint32_t>(number));
    if (!fits) return fmt::format("{} does not fit in 32 bits", number);
    // Exact, since no range of the house goes beyond 2^53.
    const auto real = static_cast<double>(number);
    return field.range && (real < field.range->min || real > field.range->max) ? outside(field, number) : std::string();
}

std::string real_fault(const FieldInfo& field, double number) {
    if (!std::isfinite(number)) return "the number is not finite";
    return field.range && (number < field.range->min || number > field.range->max) ? outside(field, number)
                                                                                   : std::string();
}

std::string float_fault(const FieldInfo& field, float number) {
    if (!std::isfinite(number)) return "the number is not finite";
    // In single precision, so that a bound such as 0.1 is itself allowed.
    return field.range &&
                   (number < static_cast<float>(field.range->min) || number > static_cast<float>(field.range->max))
               ? outside(field, number)
               : std::string();
}

template <int n> std::string vector_fault(const FieldInfo& field, const glm::vec<n, float>& vector) {
    for (int i = 0; i < n; ++i)
        if (std::string fault = float_fault(field, vector[i]); !fault.empty()) return fault;
    return {};
}

std::string narrowed_fault(const FieldInfo& field, double number) {
    if (field.bits == 64) return real_fault(field, number);
    if (std::isfinite(number) && std::abs(number) > std::numeric_limits<float>::max())
        return fmt::format("{} is too large", number);
    return float_fault(field, static_cast<float>(number));
}

std::string quaternion_fault(const glm::quat& q) {
    const double square = double{q.x} * q.x + double{q.y} * q.y + double{q.z} * q.z + double{q.w} * q.w;
    if (!std::isfinite(square)) return "the number is not finite";
    return std::abs(std::sqrt(square) - 1.0) <= 1e-3 ? std::string() : "a rotation is a quaternion of length 1";
}

std::string entity_fault(Entity entity) {
    return entity == Entity::null || (entity && entity.generation > 0)
               ? std::string()
               : fmt::format("{} is no handle of a world", to_string(entity));
}

std::string option_fault(const FieldInfo& field, const std::string& name) {
    if (std::ranges::find(field.options, name) != field.options.end()) return {};
    return fmt::format("\"{}\" is none of {}", name.substr(0, 60), fmt::join(field.options, ", "));
}

} // namespace

std::string_view to_string(FieldKind kind) {
    constexpr std::array<std::string_view, 11> names{"boolean",    "integer", "real", "vec2",        "vec3",  "vec4",
                                                     "quaternion", "color",   "text", "enumeration", "entity"};
    return names[static_cast<std::size_t>(kind)];
}

FieldValue FieldInfo::get(const void* component) const {
    FieldValue value = read(component);
    if (kind != FieldKind::enumeration) return value;
    const auto index = std::get<std::int64_t>(value);
    HACHURE_ASSERT(index >= 0 && std::cmp_less(index, options.size()), "an enumeration holds one of its options");
    return options[static_cast<std::size_t>(index)];
}

void FieldInfo::set(void* component, const FieldValue& value) const {
    if (const std::string found = fault(value); !found.empty()) throw Error(path, found);
    if (kind != FieldKind::enumeration) return write(component, value);
    const auto option = std::ranges::find(options, std::get<std::string>(value));
    write(component, std::int64_t{option - options.begin()});
}

std::string FieldInfo::fault(const FieldValue& value) const {
    if (value.index() != default_value.index()) return fmt::format("the value is no {}", to_string(kind));
    struct Check {
        const FieldInfo& field;
        std::string operator()(bool) const { return {}; }
        std::string operator()(std::int64_t number) const { return integer_fault(field, number); }
        std::string operator()(std::uint64_t number) const { return integer_fault(field, number); }
        std::string operator()(double number) const { return narrowed_fault(field, number); }
        std::string operator()(const glm::vec2& vector) const { return vector_fault<2>(field, vector); }
        std::string operator()(const glm::vec3& vector) const { return vector_fault<3>(field, vector); }
        std::string operator()(const glm::vec4& vector) const { return vector_fault<4>(field, vector); }
        std::string operator()(const glm::quat& q) const { return quaternion_fault(q); }
        std::string operator()(Entity entity) const { return entity_fault(entity); }
        std::string operator()(const std::string& text) const {
            return field.kind == FieldKind::enumeration ? option_fault(field, text) : std::string();
        }
    };
    return std::visit(Check{*this}, value);
}

} // namespace hachure
