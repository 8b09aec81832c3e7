#pragma once

#include <hachure/components/feature_image.h>

namespace hachure {

/// The settings that a quality stands for; those of `custom` are the fields themselves.
[[nodiscard]] FeatureImage resolved(const FeatureImage& image);

} // namespace hachure
