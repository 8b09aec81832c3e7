#include <hachure/runtime/assert.h>
#include <hachure/systems/timeline/track_writer.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace hachure {

int numbers_of(const FieldInfo& field) {
    switch (field.kind) {
    case FieldKind::real:
        return 1;
    case FieldKind::vec2:
        return 2;
    case FieldKind::vec3:
        return 3;
    case FieldKind::vec4:
    case FieldKind::quaternion:
        return 4;
    case FieldKind::color:
        return std::holds_alternative<glm::vec3>(field.default_value) ? 3 : 4;
    case FieldKind::boolean:
    case FieldKind::integer:
    case FieldKind::text:
    case FieldKind::enumeration:
    case FieldKind::entity:
        break;
    }
    return 0;
}

TrackWriter::TrackWriter(const TypeRegistry& types, const TimelineTrack& track)
    : type_(types.find(track.component)), field_(type_ ? type_->field(track.field) : nullptr) {
    HACHURE_ASSERT(field_, "a timeline's tracks name fields that exist");
    offset_ = field_->offset;
    count_ = numbers_of(*field_);
    if (track.element < 0) return;
    HACHURE_ASSERT(track.element < count_ && field_->kind != FieldKind::quaternion, "an element is one of the field's");
    offset_ += static_cast<std::size_t>(track.element) * sizeof(float);
    count_ = 1;
}

TrackWrite TrackWriter::write_numbers(World& world, Entity entity, const glm::dvec4& value) const {
    return field_->kind == FieldKind::real && field_->bits == 64 ? write<double>(world, entity, value)
                                                                 : write<float>(world, entity, value);
}

/// Vectors and quaternions lie in memory as x, y, z, w.
template <class Number> TrackWrite TrackWriter::write(World& world, Entity entity, const glm::dvec4& value) const {
    const auto* component = static_cast<const std::byte*>(type_->find(world, entity));
    if (!component) return TrackWrite::refused;
    Number numbers[4];
    for (int i = 0; i < count_; ++i) {
        const double wanted = field_->range ? std::clamp(value[i], field_->range->min, field_->range->max) : value[i];
        numbers[i] = static_cast<Number>(wanted);
        if (!std::isfinite(numbers[i])) return TrackWrite::same;
    }
    const std::size_t size = static_cast<std::size_t>(count_) * sizeof(Number);
    if (std::memcmp(component + offset_, numbers, size) == 0) return TrackWrite::same;
    std::memcpy(static_cast<std::byte*>(type_->find_mutable(world, entity)) + offset_, numbers, size);
    return TrackWrite::written;
}

TrackWrite TrackWriter::write_choice(World& world, Entity entity, const FieldValue& value) const {
    const void* component = type_->find(world, entity);
    if (!component) return TrackWrite::refused;
    if (field_->get(component) == value) return TrackWrite::same;
    field_->set(type_->find_mutable(world, entity), value);
    return TrackWrite::written;
}

} // namespace hachure
