#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/gltf_meshopt.h>

#include <meshoptimizer.h>

namespace hachure::assets {
namespace {

void apply_filter(const MeshoptView& view, std::span<std::byte> out) {
    switch (view.filter) {
    case MeshoptFilter::none:
        break;
    case MeshoptFilter::octahedral:
        meshopt_decodeFilterOct(out.data(), view.count, view.stride);
        break;
    case MeshoptFilter::quaternion:
        meshopt_decodeFilterQuat(out.data(), view.count, view.stride);
        break;
    case MeshoptFilter::exponential:
        meshopt_decodeFilterExp(out.data(), view.count, view.stride);
        break;
    }
}

} // namespace

// The rules are those of EXT_meshopt_compression, "Specifying compressed views" and "Filters".
const char* meshopt_fault(const MeshoptView& view) {
    if (view.mode == MeshoptMode::attributes) {
        if (view.stride == 0 || view.stride % 4 != 0 || view.stride > 256)
            return "has a compressed stride that is not a multiple of 4 up to 256";
    } else {
        if (view.stride != 2 && view.stride != 4) return "has compressed indices whose stride is neither 2 nor 4";
        if (view.mode == MeshoptMode::triangles && view.count % 3 != 0)
            return "has compressed triangles whose count is not a multiple of 3";
        if (view.filter != MeshoptFilter::none) return "has a filter on compressed indices";
    }
    if (view.filter == MeshoptFilter::octahedral && view.stride != 4 && view.stride != 8)
        return "has an octahedral filter whose stride is neither 4 nor 8";
    if (view.filter == MeshoptFilter::quaternion && view.stride != 8)
        return "has a quaternion filter whose stride is not 8";
    return nullptr;
}

bool decode_meshopt(const MeshoptView& view, std::span<const std::byte> data, std::span<std::byte> out) {
    HACHURE_ASSERT(meshopt_fault(view) == nullptr, "the view must have been checked");
    HACHURE_ASSERT(out.size() == view.count * view.stride, "the output must fit the view");
    if (view.count == 0) return true;
    const auto* source = reinterpret_cast<const unsigned char*>(data.data());
    int error = 0;
    switch (view.mode) {
    case MeshoptMode::attributes:
        error = meshopt_decodeVertexBuffer(out.data(), view.count, view.stride, source, data.size());
        break;
    case MeshoptMode::triangles:
        error = meshopt_decodeIndexBuffer(out.data(), view.count, view.stride, source, data.size());
        break;
    case MeshoptMode::indices:
        error = meshopt_decodeIndexSequence(out.data(), view.count, view.stride, source, data.size());
        break;
    }
    if (error != 0) return false;
    apply_filter(view, out);
    return true;
}

} // namespace hachure::assets
