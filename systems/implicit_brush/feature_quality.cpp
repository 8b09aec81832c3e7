#include <hachure/systems/implicit_brush/feature_quality.h>

namespace hachure {

FeatureImage resolved(const FeatureImage& wanted) {
    FeatureImage made = wanted;
    switch (wanted.quality) {
    case FeatureQuality::custom:
        break;
    case FeatureQuality::standard:
        made = {.storage = FeatureStorage::rgba32f, .taps = 4, .fits = 3, .samples = wanted.samples};
        break;
    case FeatureQuality::fast:
        made = {.taps = 3, .fits = 2, .samples = wanted.samples};
        break;
    case FeatureQuality::accurate:
        made = {.storage = FeatureStorage::rgba32f, .taps = 6, .fits = 4, .samples = 2};
        break;
    }
    made.quality = FeatureQuality::custom;
    return made;
}

gpu::Format feature_format(FeatureStorage storage) {
    return storage == FeatureStorage::rgba32f ? gpu::Format::rgba32f : gpu::Format::rgba16f;
}

} // namespace hachure
