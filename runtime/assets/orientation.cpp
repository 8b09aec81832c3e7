#include <hachure/runtime/assets/orientation.h>

#include <algorithm>

namespace hachure::assets {

Image turned(Image image, int orientation) {
    if (orientation == 1) return image;
    const bool side = lies_on_its_side(orientation);
    // Of the stored image, in the order of Exif's numbers: whether the last column and the last row are seen first.
    const bool right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Image result = side ? make_image(image.height, image.width, image.channels, image.type)
                        : make_image(image.width, image.height, image.channels, image.type);
    const std::size_t bytes = static_cast<std::size_t>(image.channels) * image.bytes_per_channel();
    std::byte* out = result.pixels.data();
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x, out += bytes) {
            const int column = side ? y : x, row = side ? x : y;
            const auto from = static_cast<std::size_t>(below ? image.height - 1 - row : row) * image.row_bytes() +
                              static_cast<std::size_t>(right ? image.width - 1 - column : column) * bytes;
            std::copy_n(image.pixels.data() + from, bytes, out);
        }
    return result;
}

} // namespace hachure::assets
