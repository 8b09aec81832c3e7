#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace hachure {

/// What is drawn of a picture.
enum class PictureShow : std::uint8_t {
    picture, ///< its colours
    tone,    ///< its tones, between two colours
    bands,   ///< its tones cut into a few flat ones
    blank,   ///< nothing: lines stand on the background
};

/// The base coat of an entity with a Picture, below its lines (Lee et al. 2007); defaults where it carries
/// none. Colours are linear RGB.
struct PictureCoat {
    PictureShow show = PictureShow::picture;
    std::int32_t bands = 3;
    float softness = 0.0f;
    float smoothing = 2.0f;
    float color = 0.0f;
    glm::vec3 light{1.0f};
    glm::vec3 shade{0.08f, 0.075f, 0.11f};

    friend bool operator==(const PictureCoat&, const PictureCoat&) = default;
};

inline void reflect(TypeBuilder<PictureCoat>& type) {
    type.name("picture_coat").doc("what is drawn of a picture, below its lines");
    type.field("show", &PictureCoat::show)
        .doc("its colours, its tones, its tones cut into flat ones, or nothing")
        .options({"picture", "tone", "bands", "blank"});
    type.field("bands", &PictureCoat::bands).doc("how many tones from shade to light, evenly spaced").range(2, 16);
    type.field("softness", &PictureCoat::softness)
        .doc("width of the change from a tone to the next, as a part of the whole scale; 0 for a sharp one")
        .range(0, 1);
    type.field("smoothing", &PictureCoat::smoothing)
        .doc("how far around a pixel tones are averaged before they are cut")
        .unit("px")
        .range(0, 16);
    type.field("color", &PictureCoat::color)
        .doc("how much tones and bands keep of the picture's own colour")
        .range(0, 1);
    type.field("light", &PictureCoat::light).color().doc("colour of the lightest tone");
    type.field("shade", &PictureCoat::shade).color().doc("colour of the darkest tone");
}

} // namespace hachure
