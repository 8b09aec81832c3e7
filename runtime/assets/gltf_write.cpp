#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/gltf_write.h>
#include <hachure/runtime/assets/gltf_writer.h>
#include <hachure/runtime/error.h>

#include <cstring>
#include <string>
#include <utility>

namespace hachure::assets {
namespace {

using nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{1} << 31; // what readers, ours too, take

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

std::string base64(std::span<const std::byte> bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    result.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t j = i; j < i + 3; ++j)
            group = group << 8 | (j < bytes.size() ? std::to_integer<unsigned>(bytes[j]) : 0u);
        for (int shift = 18; shift >= 0; shift -= 6) result += digits[group >> shift & 63];
    }
    for (std::size_t i = 0; i < (3 - bytes.size() % 3) % 3; ++i) result[result.size() - 1 - i] = '=';
    return result;
}

void append_u32(std::string& text, std::size_t value) {
    for (int i = 0; i < 4; ++i) text += static_cast<char>(value >> 8 * i & 255);
}

/// glTF 2.0, section 4.4: a header of 12 bytes, then the chunks, each padded to 4.
void write_binary(AtomicFile& file, const json& root, std::span<const std::byte> buffer) {
    std::string text = root.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t padding = (4 - buffer.size() % 4) % 4;
    const std::size_t chunk = buffer.size() + padding;
    std::string head = "glTF";
    append_u32(head, 2);
    append_u32(head, 12 + 8 + text.size() + (chunk > 0 ? 8 + chunk : 0));
    append_u32(head, text.size());
    head += "JSON";
    file.write(bytes_of(head + text));
    if (chunk == 0) return;
    head.clear();
    append_u32(head, chunk);
    head.append("BIN\0", 4);
    file.write(bytes_of(head));
    file.write(buffer);
    file.write(bytes_of(std::string(padding, '\0')));
}

void write_text(AtomicFile& file, json& root, std::span<const std::byte> buffer) {
    if (!buffer.empty()) root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer);
    file.write(bytes_of(root.dump(1) + "\n"));
}

} // namespace

void write_extras(json& object, const std::string& extras) {
    if (!extras.empty()) object["extras"]["hachure"] = json::parse(extras);
}

void put_array(GltfWriter& writer, const char* array, json values) {
    if (!values.empty()) writer.root[array] = std::move(values);
}

void write_gltf(const Model& model, const std::filesystem::path& path) {
    AtomicFile file(path); // says at once whether it can be written
    GltfWriter writer{.model = model};
    writer.root["asset"] = {{"version", "2.0"}, {"generator", "Hachure"}};
    write_look(writer);
    write_meshes(writer);
    write_nodes(writer);
    write_animations(writer);
    put_array(writer, "accessors", writer.data.accessors());
    put_array(writer, "bufferViews", writer.data.views());
    const std::span<const std::byte> buffer = writer.data.buffer();
    if (buffer.size() > most_bytes) throw Error(path.string(), "would be larger than 2 GiB, which glTF files can't be");
    if (!buffer.empty()) writer.root["buffers"] = {{{"byteLength", buffer.size()}}};
    if (!writer.extensions.empty()) writer.root["extensionsUsed"] = writer.extensions;
    if (lower_extension(path) == ".glb")
        write_binary(file, writer.root, buffer);
    else
        write_text(file, writer.root, buffer);
    file.commit();
}

} // namespace hachure::assets
