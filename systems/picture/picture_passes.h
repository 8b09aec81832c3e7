#pragma once

#include <hachure/components/picture_coat.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/systems/picture/picture_textures.h>

namespace hachure {

/// Declares the passes of pictures: `picture` draws them behind the surfaces, `picture_tone` and `picture_color` make
/// the textures of these names for whoever asked.
class PicturePasses {
public:
    void declare(World& world);

    /// PictureTones::draw.
    void draw_tone(World& world, const PictureItem& item);

private:
    void declare_base(World& world);
    void declare_texture(World& world, const char* name, gpu::Format format, bool is_tone);

    PictureTextures textures_;
};

} // namespace hachure
