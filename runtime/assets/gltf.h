#pragma once

#include <hachure/runtime/assets/model.h>

#include <filesystem>

namespace hachure::assets {

/// Reads a glTF 2.0 file, .gltf or .glb (told apart by content), with the buffers and images beside it.
///
/// The result is valid in every sense of model.h, except that `Primitive::normals` is empty where the file has none or
/// has unusable ones: `complete_normals` (complete.h) fills those. Images stay encoded. A model may have no triangle at
/// all, a file of clips for example.
///
/// Understood: accessors of every component type (normalised, sparse, interleaved), strips and fans, scenes, cameras,
/// skins, morph targets, animations, KHR_lights_punctual, KHR_texture_transform, KHR_mesh_quantization,
/// EXT_meshopt_compression, and KHR_animation_pointer (as channels that keep their pointer).
///
/// What is not understood (other extensions, points and lines, textures that are neither PNG nor JPEG, images that are
/// missing or lie outside the file's folder) is skipped and named once in `Model::warnings`. So is what is repaired:
/// non-finite texture coordinates, colours, weights and morph displacements become zero, unusable normals and tangents
/// are dropped.
///
/// Throws hachure::Error with a JSON pointer when the file cannot be read, is not glTF 2.0, requires an extension that
/// is not understood, or contradicts itself: a value of the wrong type, an index or a range outside what it points
/// into, a node with two parents or among its own descendants, positions, inverse bind matrices or keys that are not
/// finite, arrays whose sizes do not fit each other, a buffer outside the file's folder. What decoding may allocate is
/// bounded by the bytes that the file really has: 64 MiB + 32 times those, whatever counts it claims.
[[nodiscard]] Model read_gltf(const std::filesystem::path& file);

} // namespace hachure::assets
