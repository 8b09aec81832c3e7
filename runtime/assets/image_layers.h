#pragma once

#include <span>
#include <string>
#include <vector>

namespace hachure::assets {

/// A channel of an image file. A multi-part EXR has channels in each part; other files have one part.
struct ImageChannel {
    int part = 0;     ///< from 0
    int index = 0;    ///< in its part, from 0
    std::string name; ///< with its layers: "R", "N.X", "ViewLayer.Depth.Z"

    friend bool operator==(const ImageChannel&, const ImageChannel&) = default;
};

/// Which channels of an EXR hold what is drawn.
struct ImageLayers {
    std::vector<ImageChannel> color;  ///< Y, Y A, R G B, R G B A, or 1 to 4 that have no such names; empty: none
    std::vector<ImageChannel> normal; ///< x, y, z; or empty
    std::vector<ImageChannel> depth;  ///< one; or empty
};

/// Finds them by their names, of which renderers have no two alike; capitals do not count. A channel "a.b.X" is X of
/// layer b, and a name without a dot belongs to no layer. Where several would do, the first rule decides, then the
/// order of the channels:
/// - colour: R, G, B (and A) of no layer; of layer combined, rgba, rgb, beauty, color, colour, image; Y (and A) of no
///   layer; R, G, B of any other layer; the first channels, at most four, of the first part that has some left;
/// - normal: X, Y, Z or R, G, B of layer n, normal, normals, nn, shading_normal;
/// - depth: Z of no layer; Z, V, R, Y of layer depth, z, zdepth; Z of the colour's layer; "depth" of no layer.
/// Red, green, blue, alpha mean R, G, B, A. No channel is in two of them.
[[nodiscard]] ImageLayers find_layers(std::span<const ImageChannel> channels);

} // namespace hachure::assets
