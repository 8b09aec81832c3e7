#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/texture.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/systems/picture/picture_file.h>

#include <map>
#include <string>

namespace hachure {

/// The frames that pictures show, on the GPU, each read when a pass first needs it: frames of a video that nobody draws
/// are not decoded. All at the size of the file.
class PictureTextures {
public:
    /// Says what the passes of this frame may ask for of the item, so that its frame is decoded once for all of them.
    void want(const PictureItem& item, bool color, bool tone);

    /// The same, of the tone besides what was said before.
    void want_tone(const PictureItem& item) { frames_[item.entity].wants_tone = true; }

    /// Linear light, multiplied by alpha. Throws Error for a file that can't be decoded, or is larger than the context
    /// allows.
    const gpu::Texture& color(const gpu::Context& context, PictureFile& file, const PictureItem& item);

    /// The tone, in red; errors as color().
    const gpu::Texture& tone(const gpu::Context& context, PictureFile& file, const PictureItem& item);

    /// Frees what belongs to no picture of the list.
    void forget_all_but(const PictureList& list);

private:
    struct Frame {
        std::string file;
        int frame = -1;
        bool wants_color = false, wants_tone = false;
        bool has_color = false, has_tone = false;
        gpu::Texture color, tone;
    };

    /// The item's frame, with what is wanted of it.
    Frame& frame(const gpu::Context& context, PictureFile& file, const PictureItem& item);

    std::map<Entity, Frame> frames_;
};

} // namespace hachure
