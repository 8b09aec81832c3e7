#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/assets/gltf_buffers.h>
#include <hachure/runtime/assets/gltf_data_uri.h>
#include <hachure/runtime/assets/gltf_meshopt.h>
#include <hachure/runtime/assets/path_rules.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

namespace hachure::assets {
namespace {

constexpr const char* meshopt_extension = "EXT_meshopt_compression";

std::size_t size_of(const tinygltf::Value& object, const std::string& key) {
    const int value = object.Get(key).GetNumberAsInt(); // 0 when absent
    return static_cast<std::size_t>(value);
}

MeshoptView meshopt_view(const tinygltf::Value& extension) {
    MeshoptView view;
    view.count = size_of(extension, "count");
    view.stride = size_of(extension, "byteStride");
    const std::string mode = extension.Get("mode").Get<std::string>();
    view.mode = mode == "TRIANGLES" ? MeshoptMode::triangles
                : mode == "INDICES" ? MeshoptMode::indices
                                    : MeshoptMode::attributes;
    if (!extension.Has("filter")) return view;
    const std::string filter = extension.Get("filter").Get<std::string>();
    view.filter = filter == "OCTAHEDRAL"    ? MeshoptFilter::octahedral
                  : filter == "QUATERNION"  ? MeshoptFilter::quaternion
                  : filter == "EXPONENTIAL" ? MeshoptFilter::exponential
                                            : MeshoptFilter::none;
    return view;
}

} // namespace

GltfBuffers::GltfBuffers(const GltfDocument& document, ByteBudget& budget)
    : document_(document), budget_(budget), buffers_(document.buffers.size()) {
    budget_.add_input(document.bytes.size());
}

std::span<const std::byte> GltfBuffers::view(int buffer_view) {
    const tinygltf::BufferView& view = document_.model->bufferViews[static_cast<std::size_t>(buffer_view)];
    if (view.extensions.contains(meshopt_extension)) return decompress(buffer_view);
    return buffer(static_cast<std::size_t>(view.buffer)).subspan(view.byteOffset, view.byteLength);
}

std::span<const std::byte> GltfBuffers::resource(const std::string& uri, const std::string& where) {
    if (is_data_uri(uri)) {
        auto bytes = decode_data_uri(uri);
        if (!bytes) document_.fail("has a data URI that is not base64", where);
        return decoded_uris_.emplace_back(std::move(*bytes));
    }
    const std::filesystem::path path = resolve_beside(document_.path, uri, where).lexically_normal();
    if (const auto known = files_.find(path); known != files_.end()) return known->second;
    std::vector<std::byte> bytes;
    try {
        bytes = read_file_bytes(path, max_file_bytes - file_bytes_);
    } catch (const Error& error) {
        document_.fail(fmt::format("needs a file: {}", error.what()), where);
    }
    file_bytes_ += bytes.size();
    budget_.add_input(bytes.size());
    return files_.emplace(path, std::move(bytes)).first->second;
}

std::span<const std::byte> GltfBuffers::buffer(std::size_t index) {
    if (!buffers_[index]) buffers_[index] = load_buffer(index);
    return *buffers_[index];
}

std::span<const std::byte> GltfBuffers::load_buffer(std::size_t index) {
    const GltfBufferSource& source = document_.buffers[index];
    const std::string where = fmt::format("/buffers/{}", index);
    std::span<const std::byte> bytes;
    if (source.uri)
        bytes = resource(*source.uri, where);
    else if (index == 0 && document_.binary)
        bytes = *document_.binary;
    else
        document_.fail("has a buffer in use that has no data", where);
    if (bytes.size() < source.byte_length)
        document_.fail(fmt::format("has a buffer of {} bytes that claims {}", bytes.size(), source.byte_length), where);
    return bytes.first(source.byte_length);
}

std::span<const std::byte> GltfBuffers::decompress(int buffer_view) {
    if (const auto known = decompressed_.find(buffer_view); known != decompressed_.end()) return known->second;
    const tinygltf::BufferView& target = document_.model->bufferViews[static_cast<std::size_t>(buffer_view)];
    const tinygltf::Value& extension = target.extensions.at(meshopt_extension);
    const MeshoptView view = meshopt_view(extension);
    const std::string where = fmt::format("/bufferViews/{}", buffer_view);
    if (const char* fault = meshopt_fault(view)) document_.fail(fault, where);
    const std::size_t bytes = view.count * view.stride;
    if (target.byteLength != bytes)
        document_.fail(fmt::format("has a view of {} bytes that decompresses to {}", target.byteLength, bytes), where);

    budget_.spend(bytes, 1, where);
    std::vector<std::byte> out(bytes);
    const auto data = buffer(size_of(extension, "buffer"))
                          .subspan(size_of(extension, "byteOffset"), size_of(extension, "byteLength"));
    if (!decode_meshopt(view, data, out)) document_.fail("has broken compressed data", where);
    return decompressed_.emplace(buffer_view, std::move(out)).first->second;
}

} // namespace hachure::assets
