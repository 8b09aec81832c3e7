#pragma once

#include <hachure/runtime/assets/byte_budget.h>
#include <hachure/runtime/assets/gltf_document.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hachure::assets {

/// The bytes behind a document's buffers and images. Files beside the document are read when first asked for, once
/// each, all of them together within max_file_bytes; what they hold counts as input of the budget.
class GltfBuffers {
public:
    /// Both must outlive this.
    GltfBuffers(const GltfDocument& document, ByteBudget& budget);

    /// The bytes of a buffer view, decompressed where it is compressed. Throws hachure::Error when its buffer cannot be
    /// read or is too short, or the compressed data is broken.
    [[nodiscard]] std::span<const std::byte> view(int buffer_view);

    /// The content of a `data:` uri or of a file beside the document; `where` is the JSON pointer for errors.
    [[nodiscard]] std::span<const std::byte> resource(const std::string& uri, const std::string& where);

private:
    std::span<const std::byte> buffer(std::size_t index);
    std::span<const std::byte> load_buffer(std::size_t index);
    std::span<const std::byte> decompress(int buffer_view);

    const GltfDocument& document_;
    ByteBudget& budget_;
    std::vector<std::optional<std::span<const std::byte>>> buffers_; // loaded so far
    std::map<std::filesystem::path, std::vector<std::byte>> files_;  // read so far
    std::map<int, std::vector<std::byte>> decompressed_;             // by buffer view
    std::vector<std::vector<std::byte>> decoded_uris_;               // the targets of spans that were given out
    std::uint64_t file_bytes_ = 0;
};

} // namespace hachure::assets
