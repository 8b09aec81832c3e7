#include <hachure/runtime/assets/image_sequence.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

namespace hachure::assets {
namespace {

/// Throws where a file can't follow the first.
void check_alike(const std::filesystem::path& file, const ImageInfo& info, const std::filesystem::path& first_file,
                 const ImageInfo& first) {
    const auto refuse = [&](const std::string& fault) {
        throw Error(file.string(), fault + " the sequence's first, " + first_file.filename().string() + ", has");
    };
    const ImageSize size = info.size, wanted = first.size;
    if (size.width != wanted.width || size.height != wanted.height)
        refuse(
            fmt::format("has {}x{} pixels, not the {}x{} that", size.width, size.height, wanted.width, wanted.height));
    if (info.layers.normal.empty() && !first.layers.normal.empty()) refuse("lacks the normals that");
    if (info.layers.depth.empty() && !first.layers.depth.empty()) refuse("lacks the depth that");
}

bool is_of_size(const std::optional<Image>& layer, ImageSize size) {
    return !layer || (layer->width == size.width && layer->height == size.height);
}

} // namespace

ImageSequence::ImageSequence(const std::filesystem::path& pattern)
    : files_(pattern), info_(read_image_info(files_.file(0))) {
    const std::int64_t lowest = files_.numbers().front();
    for (const std::int64_t number : files_.numbers().subspan(1)) {
        const std::filesystem::path file = files_.file(static_cast<int>(number - lowest));
        check_alike(file, read_image_info(file), files_.file(0), info_);
    }
}

LayeredImage ImageSequence::read_frame(int index, WantedLayers wanted) const {
    const std::filesystem::path file = files_.file(index);
    LayeredImage image = read_layers(file, wanted);
    const bool normal = wanted.normal && !info_.layers.normal.empty();
    const bool depth = wanted.depth && !info_.layers.depth.empty();
    bool same = (!normal || image.normal) && (!depth || image.depth);
    for (const std::optional<Image>* layer : {&image.color, &image.normal, &image.depth})
        same = same && is_of_size(*layer, info_.size);
    if (!same) throw Error(file.string(), "has another size, or other layers, than when it was opened");
    return image;
}

} // namespace hachure::assets
