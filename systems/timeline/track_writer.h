#pragma once

#include <hachure/components/timeline.h>
#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec4.hpp>

namespace hachure {

/// What became of a value.
enum class TrackWrite {
    written,
    same,    ///< the field had it
    refused, ///< the entity is dead or has no such component
};

/// Writes what a track gives into the field of an entity; only what differs, so that nothing is marked as changed that
/// is not.
class TrackWriter {
public:
    /// The types know the track's component and field; the reader of documents has checked it.
    TrackWriter(const TypeRegistry& types, const TimelineTrack& track);

    /// Numbers are brought into the field's range, as easing and splines may leave it; what is not finite is dropped.
    TrackWrite write_numbers(World& world, Entity entity, const glm::dvec4& value) const;

    TrackWrite write_choice(World& world, Entity entity, const FieldValue& value) const;

    [[nodiscard]] const TypeInfo& type() const { return *type_; }

private:
    template <class Number> TrackWrite write(World& world, Entity entity, const glm::dvec4& value) const;

    const TypeInfo* type_;
    const FieldInfo* field_;
    std::size_t offset_ = 0; ///< of the first number in the component
    int count_ = 1;          ///< how many numbers
};

/// How many numbers a field is made of: 1 to 4, or 0 when its values are taken in steps.
[[nodiscard]] int numbers_of(const FieldInfo& field);

} // namespace hachure
