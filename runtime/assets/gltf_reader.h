#pragma once

#include <hachure/runtime/assets/gltf_accessor.h>
#include <hachure/runtime/assets/gltf_document.h>
#include <hachure/runtime/assets/gltf_warnings.h>
#include <hachure/runtime/assets/model.h>

#include <optional>

/// The steps of read_gltf: each fills one part of the Model from a checked document, with the four things of GltfReader
/// in common, and throws hachure::Error about the file.
namespace hachure::assets {

struct GltfReader {
    const GltfDocument& document;
    GltfBuffers& buffers;
    GltfAccessors& accessors;
    GltfWarnings& warnings;
};

/// Images, still encoded, and the textures that use them.
void read_textures(const GltfReader& reader, Model& model);
void read_materials(const GltfReader& reader, Model& model);
void read_cameras(const GltfReader& reader, Model& model);
void read_lights(const GltfReader& reader, Model& model);

/// Meshes, by their index in the file; primitives that draw no triangles are left out.
void read_meshes(const GltfReader& reader, Model& model);

/// Which primitive of which mesh of the file.
struct GltfPrimitiveAt {
    std::size_t mesh = 0;
    std::size_t primitive = 0;
};

/// The primitive's triangles and attributes, or nullopt when it draws no triangle.
[[nodiscard]] std::optional<Primitive> read_primitive(const GltfReader& reader, GltfPrimitiveAt at);
/// The primitive's morph targets; its base attributes must have been read.
void read_morph_targets(const GltfReader& reader, GltfPrimitiveAt at, Primitive& primitive);

/// Nodes with their parents, scenes; throws when the graph is not a forest. After read_meshes.
void read_nodes(const GltfReader& reader, Model& model);
/// After read_nodes: joints, and the check of every skinned mesh's joint indices against them.
void read_skins(const GltfReader& reader, Model& model);
/// After read_meshes and read_nodes: the width of a channel of morph weights depends on them.
void read_animations(const GltfReader& reader, Model& model);

} // namespace hachure::assets
