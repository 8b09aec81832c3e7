#pragma once

#include <hachure/runtime/assets/image.h>

namespace hachure::assets {

/// How a stored image is to be turned to be seen, as Exif numbers it: 1 upright; 3 upside down; 2 and 4 mirrored; 5 to
/// 8 on its side. Other numbers mean nothing: 1.
[[nodiscard]] constexpr int orientation_from(int number) { return number >= 1 && number <= 8 ? number : 1; }

/// Width and height change places.
[[nodiscard]] constexpr bool lies_on_its_side(int orientation) { return orientation >= 5; }

/// The image as it is to be seen.
[[nodiscard]] Image turned(Image image, int orientation);

} // namespace hachure::assets
