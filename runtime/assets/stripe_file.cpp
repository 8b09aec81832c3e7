#include <hachure/runtime/assets/stripe_file.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace hachure::assets {
namespace {

constexpr std::uint64_t version = 3; ///< to be raised when the method's results or the format change
constexpr char magic[] = {'H', 'A', 'C', 'H', 'S', 'T', 'R', 'P'};

/// A 64-bit hash of words, one multiplication and one rotation each (the rounds of xxHash64's tail).
class Hash {
public:
    explicit Hash(std::uint64_t seed) : state_(seed) {}

    void add(std::uint64_t word) {
        word *= 0xc2b2ae3d27d4eb4full;
        word = std::rotl(word, 31) * 0x9e3779b185ebca87ull;
        state_ = std::rotl(state_ ^ word, 27) * 0x9e3779b185ebca87ull + 0x85ebca77c2b2ae63ull;
    }

    void add(std::span<const std::byte> bytes) {
        add(bytes.size());
        for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
            std::uint64_t word;
            std::memcpy(&word, bytes.data(), 8);
            add(word);
        }
        std::uint64_t rest = 0;
        if (!bytes.empty()) std::memcpy(&rest, bytes.data(), bytes.size());
        add(rest);
    }

    [[nodiscard]] std::uint64_t value() const {
        std::uint64_t x = state_;
        x = (x ^ (x >> 33)) * 0xc2b2ae3d27d4eb4full;
        x = (x ^ (x >> 29)) * 0x165667b19e3779f9ull;
        return x ^ (x >> 32);
    }

private:
    std::uint64_t state_;
};

struct Header {
    char name[8];
    StripeKey key;
    std::uint64_t vertices, indices, hash;
};

std::uint64_t hash_of(std::span<const std::byte> bytes, std::uint64_t seed = 0) {
    Hash hash(seed);
    hash.add(bytes);
    return hash.value();
}

std::uintmax_t file_size(std::uintmax_t vertices, std::uintmax_t indices) {
    return sizeof(Header) + 33 * vertices + 4 * indices;
}

template <class T> void append(std::vector<std::byte>& bytes, const std::vector<T>& values) {
    const auto more = std::as_bytes(std::span(values));
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Takes an array off the front.
template <class T> void take(std::span<const std::byte>& bytes, std::size_t count, std::vector<T>& values) {
    values.resize(count);
    if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
    bytes = bytes.subspan(count * sizeof(T));
}

bool is_sound(const geometry::StripeMesh& mesh, std::size_t vertices, std::span<const std::uint32_t> indices) {
    const std::size_t count = mesh.source_vertex.size();
    for (std::size_t v = 0; v < count; ++v) {
        if (v < vertices ? mesh.source_vertex[v] != v : mesh.source_vertex[v] >= vertices) return false;
        if (mesh.stands_for[v] >= count || mesh.mirrored[v] > 1) return false;
        if (!(std::abs(mesh.coordinate[v]) <= 1e5f) || !(mesh.weight[v] >= 0.0f && mesh.weight[v] <= 1.0f))
            return false;
        if (!(std::abs(glm::length(mesh.lean[v]) - 1.0f) < 1e-4f) ||
            !(mesh.clarity[v] >= 0.0f && mesh.clarity[v] <= 1.0f))
            return false;
    }
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (mesh.indices[i] >= count || mesh.source_vertex[mesh.indices[i]] != indices[i]) return false;
    return true;
}

} // namespace

StripeKey stripe_key(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                     std::span<const std::uint32_t> indices, const geometry::StripeSettings& settings) {
    StripeKey key{};
    for (std::size_t i = 0; i < key.size(); ++i) {
        Hash hash(i);
        hash.add(version);
        for (const double number : {settings.sets, settings.detail, settings.crease_angle})
            hash.add(std::bit_cast<std::uint64_t>(number));
        hash.add(std::as_bytes(positions));
        hash.add(std::as_bytes(normals));
        hash.add(std::as_bytes(indices));
        key[i] = hash.value();
    }
    return key;
}

std::string stripe_file_name(const StripeKey& key) { return fmt::format("{:016x}{:016x}.stripes", key[0], key[1]); }

std::vector<std::byte> stripe_file_bytes(const StripeKey& key, const geometry::StripeMesh& mesh) {
    Header header{
        .name = {}, .key = key, .vertices = mesh.source_vertex.size(), .indices = mesh.indices.size(), .hash = 0};
    std::ranges::copy(magic, header.name);
    std::vector<std::byte> bytes(sizeof header);
    bytes.reserve(file_size(header.vertices, header.indices));
    append(bytes, mesh.source_vertex);
    append(bytes, mesh.stands_for);
    append(bytes, mesh.coordinate);
    append(bytes, mesh.weight);
    append(bytes, mesh.lean);
    append(bytes, mesh.clarity);
    append(bytes, mesh.indices);
    append(bytes, mesh.mirrored);
    header.hash = hash_of(std::span(bytes).subspan(sizeof header));
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
}

std::uintmax_t most_stripe_file_bytes(std::size_t vertices, std::size_t indices) {
    return file_size(static_cast<std::uintmax_t>(vertices) + indices, indices);
}

std::optional<geometry::StripeMesh> read_stripe_file(std::span<const std::byte> bytes, const StripeKey& key,
                                                     std::size_t vertices, std::span<const std::uint32_t> indices) {
    Header header;
    if (bytes.size() < sizeof header) return std::nullopt;
    std::memcpy(&header, bytes.data(), sizeof header);
    if (!std::ranges::equal(header.name, magic) || header.key != key || header.indices != indices.size() ||
        header.vertices < vertices || header.vertices - vertices > indices.size() ||
        bytes.size() != file_size(header.vertices, header.indices))
        return std::nullopt;
    bytes = bytes.subspan(sizeof header);
    if (hash_of(bytes) != header.hash) return std::nullopt;
    geometry::StripeMesh mesh;
    const auto count = static_cast<std::size_t>(header.vertices);
    take(bytes, count, mesh.source_vertex);
    take(bytes, count, mesh.stands_for);
    take(bytes, count, mesh.coordinate);
    take(bytes, count, mesh.weight);
    take(bytes, count, mesh.lean);
    take(bytes, count, mesh.clarity);
    take(bytes, indices.size(), mesh.indices);
    take(bytes, count, mesh.mirrored);
    if (!is_sound(mesh, vertices, indices)) return std::nullopt;
    return mesh;
}

} // namespace hachure::assets
