#pragma once

#include <hachure/components/feature_image.h>
#include <hachure/runtime/gpu/texture_desc.h>

namespace hachure {

/// The settings that a quality stands for, as `custom`.
[[nodiscard]] FeatureImage resolved(const FeatureImage& wanted);

[[nodiscard]] gpu::Format feature_format(FeatureStorage storage);

} // namespace hachure
