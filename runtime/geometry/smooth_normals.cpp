#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/corner_weight.h>
#include <hachure/runtime/geometry/normals.h>

#include <algorithm>

namespace hachure::geometry {

void SmoothNormalsJob::validate() const {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(weld.size() == positions.size() && normals.size() == positions.size(), "one element per vertex");
    const auto in_range = [&](std::uint32_t i) { return i < positions.size(); };
    HACHURE_ASSERT(std::ranges::all_of(indices, in_range) && std::ranges::all_of(weld, in_range),
                   "indices must be in range");
}

void SmoothNormalsJob::run() {
    sums.assign(positions.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const CornerNormals n =
            corner_normals(positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]], weight);
        for (std::size_t k = 0; k < 3; ++k) sums[weld[indices[i + k]]] += n.corner[k];
    }
    for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = normal_of_sum(sums[weld[v]]);
}

} // namespace hachure::geometry
