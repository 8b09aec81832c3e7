#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <cstdint>
#include <string>

namespace hachure {

/// How a picture fills a view that has another shape.
enum class PictureFit : std::uint8_t {
    stretch, ///< all of both, the picture out of proportion
    contain, ///< all of the picture, in the middle
    cover,   ///< all of the view; what sticks out is cut off
};

/// An image, a video or numbered images behind all surfaces of the view (PictureCoat says how it is drawn). The entity
/// needs no place.
///
/// Its tone is what the eye sees as grey, from 0 black to 1 white: the linear luminance (Rec. 709: .2126 R + .7152 G +
/// .0722 B) through sRGB's curve, cut to [0, 1]. So the tone of a grey pixel of an 8-bit file is its value / 255.
/// Colours of 8-bit files and videos are sRGB, those of float files (EXR, HDR) linear. What is transparent lies on
/// white.
///
/// A frame of a video follows from the time alone: at second t of the scene it is the one that the video shows at
/// second time_offset + speed * t; before the first and past the last, these stand still unless it is a loop. Numbered
/// images ("shot.####.exr": those that are there, from the lowest number on) are a video of frames_per_second.
///
/// An EXR may say more than colours: normals and depth of what another renderer saw (docs/pictures.md).
struct Picture {
    std::string file;
    bool visible = true;
    PictureFit fit = PictureFit::contain;
    float time_offset = 0.0f;
    float speed = 1.0f;
    bool loop = false;
    float frames_per_second = 30.0f;

    friend bool operator==(const Picture&, const Picture&) = default;
};

inline void reflect(TypeBuilder<Picture>& type) {
    type.name("picture").doc("an image, a video or numbered images behind all surfaces");
    type.field("file", &Picture::file)
        .doc("the image, the video, or numbered images as shot.####.exr; empty for none")
        .unit("image or video file");
    type.field("visible", &Picture::visible).doc("is drawn");
    type.field("fit", &Picture::fit)
        .doc("how it fills the view: out of proportion, all of the picture, or all of the view")
        .options({"stretch", "contain", "cover"});
    type.field("time_offset", &Picture::time_offset)
        .doc("second of the video that shows at second 0 of the scene")
        .unit("s")
        .range(-1e6, 1e6);
    type.field("speed", &Picture::speed).doc("seconds of the video in a second").range(0, 100);
    type.field("loop", &Picture::loop).doc("the video begins again at its end, else its last frame stays");
    type.field("frames_per_second", &Picture::frames_per_second)
        .doc("rate of numbered images; a video has its own")
        .unit("1/s")
        .range(1, 1000);
}

} // namespace hachure
