#pragma once

#include <hachure/runtime/assets/model.h>

namespace hachure::assets {

/// The last step of reading a model: computes the normals of every primitive that has none (`geometry::vertex_normals`)
/// and marks it `normals_computed`, so that the model fulfils model.h's promise. Leaves the others as they are.
void complete_normals(Model& model);

} // namespace hachure::assets
