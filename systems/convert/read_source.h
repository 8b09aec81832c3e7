#pragma once

#include <hachure/runtime/assets/model.h>

#include <filesystem>

namespace hachure {

/// Reads a model to be written again: as assets::read_model, but a glTF file's stays as it is, without the normals that
/// it lacks, which whoever reads the result computes as well. Throws Error.
[[nodiscard]] assets::Model read_source(const std::filesystem::path& file);

} // namespace hachure
