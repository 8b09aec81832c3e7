#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <cstdint>

namespace hachure {

/// How much work goes into finding features: docs/implicit-brush-accuracy.md has the chart that these were chosen from.
enum class FeatureQuality { standard, fast, accurate, custom };

/// The format of slopes, heights and sums of stamps.
enum class FeatureStorage { rgba16f, rgba32f };

/// How features for brushes are found and stamps added up, on the camera's entity, or defaults. All but `quality` and
/// `samples` count for `custom`.
struct FeatureImage {
    FeatureQuality quality = FeatureQuality::standard;
    FeatureStorage storage = FeatureStorage::rgba16f;
    std::int32_t taps = 4;
    std::int32_t fits = 2;
    std::int32_t samples = 1;

    friend bool operator==(const FeatureImage&, const FeatureImage&) = default;
};

inline void reflect(TypeBuilder<FeatureImage>& type) {
    type.name("feature_image").doc("how features for brushes are found");
    type.field("quality", &FeatureImage::quality)
        .doc("how much work goes into finding features; custom for the fields below")
        .options({"standard", "fast", "accurate", "custom"});
    type.field("storage", &FeatureImage::storage)
        .doc("format of heights and of sums of stamps")
        .options({"rgba16f", "rgba32f"});
    type.field("taps", &FeatureImage::taps).doc("samples of a profile on either side: k of section 3.2.2").range(2, 16);
    type.field("fits", &FeatureImage::fits)
        .doc("fits on the way to a line: the first from the pixel, the others from where the one before says the line "
             "is")
        .range(1, 4);
    type.field("samples", &FeatureImage::samples)
        .doc("samples of a pixel of depth and normals, to a side: 2 for features below a pixel")
        .range(1, 2);
}

} // namespace hachure
