#include <hachure/systems/implicit_brush/feature_quality.h>

namespace hachure {

FeatureImage resolved(const FeatureImage& image) {
    FeatureImage result = image;
    switch (image.quality) {
    case FeatureQuality::custom:
        return result;
    case FeatureQuality::fast:
        result.storage = FeatureStorage::rgba16f;
        result.taps = 3;
        result.fits = 1;
        return result;
    case FeatureQuality::standard:
        result.storage = FeatureStorage::rgba16f;
        result.taps = 4;
        result.fits = 2;
        return result;
    case FeatureQuality::accurate:
        result.storage = FeatureStorage::rgba32f;
        result.taps = 4;
        result.fits = 3;
        return result;
    }
    return result;
}

} // namespace hachure
