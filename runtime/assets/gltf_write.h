#pragma once

#include <hachure/runtime/assets/model.h>

#include <filesystem>

namespace hachure::assets {

/// Writes a model as one self-contained glTF 2.0 file: binary for the extension .glb, else JSON with its buffer as a
/// data URI. The file appears whole or not at all, and reading it gives the same model: every number is written as it
/// is (reading makes rotations and normals unit again), images stay the bytes that they are, extras are an object
/// (gltf_extras.h). Arrays that are equal are stored once.
///
/// What the model does not hold can't be written: extensions that the reader does not understand are lost. So are
/// meshes without a triangle. Factors of materials are cut to [0, 1], as glTF has them. For a file like the one that
/// was read, take read_gltf's model, which has no computed normals.
///
/// Throws Error for more than 2 GiB of data, and when the file can't be written.
void write_gltf(const Model& model, const std::filesystem::path& file);

} // namespace hachure::assets
