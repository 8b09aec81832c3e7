#pragma once

#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace hachure {

/// Turns a model's materials into what surfaces are shaded with. A texture is decoded and stored once for every image,
/// colour space and sampling that materials use; one that can't be used costs a warning with its name, and the material
/// does without it.
class SurfaceMaterials {
public:
    /// All three must outlive it.
    SurfaceMaterials(const assets::Model& model, MeshStore& store, std::vector<std::string>& warnings)
        : model_(model), store_(store), warnings_(warnings) {}

    /// The material at an index of the model, glTF's default (white, one side) for -1.
    [[nodiscard]] SurfaceMaterial get(std::int32_t index);

    /// Gives a primitive what its material needs, and takes from it what the material does not use: the first set of
    /// texture coordinates becomes that of the base colour, the second that of the normal map where it differs;
    /// tangents are there when there is a normal map. The primitive may gain vertices.
    void prepare(assets::Primitive& primitive);

private:
    using TextureKey = std::tuple<std::int32_t, ColorSpace, assets::Wrap, assets::Wrap, assets::Filter, assets::Filter,
                                  bool>; ///< image, and how its texels are read

    std::int32_t texture(std::int32_t index, ColorSpace color_space);
    std::int32_t load(const assets::Texture& texture, ColorSpace color_space);

    const assets::Model& model_;
    MeshStore& store_;
    std::vector<std::string>& warnings_;
    std::map<TextureKey, std::int32_t> loaded_;
};

} // namespace hachure
