#pragma once

#include <hachure/components/tone_image.h>
#include <hachure/runtime/gpu/texture_desc.h>

namespace hachure {

/// What a quality stands for: the same with `custom` and every field filled in (docs/abstracted-lines-accuracy.md has
/// the chart that they were chosen from).
[[nodiscard]] ToneImage resolved(const ToneImage& wanted);

/// The texture format of tones; with widths beside them where those vary over the picture.
[[nodiscard]] gpu::Format tone_format(ToneStorage storage, bool widths);

} // namespace hachure
