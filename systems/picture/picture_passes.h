#pragma once

#include <hachure/components/picture_coat.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/systems/picture/picture_textures.h>

namespace hachure {

/// Declares the passes of pictures: `picture` draws them behind the surfaces; `picture_tone`, `picture_color`,
/// `picture_normal` and `picture_depth` make the textures of these names for whoever asked.
class PicturePasses {
public:
    void declare(World& world);

private:
    void declare_base(World& world);
    void declare_layer(World& world, PictureLayer layer);

    PictureTextures textures_;
};

} // namespace hachure
