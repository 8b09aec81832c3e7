#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/texture.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/systems/picture/picture_file.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace hachure {

/// What passes read of a picture; in the order of runtime/scene/picture_list.h.
enum class PictureLayer : std::uint8_t { tone, color, normal, depth };

/// Which of them are wanted, or there.
using PictureLayers = std::array<bool, 4>;

/// The frames that pictures show, on the GPU, each read when a pass first needs it: frames of a video that nobody draws
/// are not decoded, nor are layers of an image. All at the size of the file.
class PictureTextures {
public:
    /// Says what the passes of this frame may ask for of the item, so that its frame is decoded once for all of them.
    void want(const PictureItem& item, const PictureLayers& layers);

    /// A layer that is wanted, and that the file has:
    /// - tone: in red;
    /// - color: linear light, multiplied by alpha;
    /// - normal: of length 1, with alpha 1; 0 where there is none;
    /// - depth: metres, in red; 1e10 where there is none.
    /// Throws Error for a file that can't be decoded, or is larger than the context allows.
    const gpu::Texture& texture(PictureLayer layer, const gpu::Context& context, PictureFile& file,
                                const PictureItem& item);

    /// Frees what belongs to no picture of the list.
    void forget_all_but(const PictureList& list);

private:
    struct Frame {
        std::string file;
        int number = -1;
        PictureLayers wanted{}, read{};
        std::array<gpu::Texture, 4> textures;
    };

    /// Reads what is wanted of the frame and not there.
    void complete(Frame& frame, const gpu::Context& context, PictureFile& file, const PictureItem& item);

    std::map<Entity, Frame> frames_;
};

} // namespace hachure
