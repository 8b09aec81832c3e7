#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hachure::assets {

/// What the elements of a buffer view are for (glTF 2.0, section 3.6.2.2: bufferView.target).
enum class GltfTarget : int { none = 0, vertices = 34962, indices = 34963 };

/// The one buffer of a glTF file that is being written, with its views and accessors. What is equal to the last byte is
/// stored once.
class GltfData {
public:
    /// Each returns the index of an accessor. `bounds`: say the smallest and largest elements too, as positions and key
    /// times need.
    std::size_t scalars(std::span<const float> values, bool bounds = false);
    std::size_t vectors(std::span<const glm::vec2> values, GltfTarget target);
    std::size_t vectors(std::span<const glm::vec3> values, GltfTarget target, bool bounds = false);
    std::size_t vectors(std::span<const glm::vec4> values, GltfTarget target);
    std::size_t matrices(std::span<const glm::mat4> values);
    /// Floats in groups of 1, 3 or 4: values of keys.
    std::size_t groups(std::span<const float> values, std::size_t width);
    /// As 16 bits when all indices fit.
    std::size_t indices(std::span<const std::uint32_t> values);
    /// As bytes when all fit.
    std::size_t joints(std::span<const glm::u16vec4> values);

    /// The index of a buffer view of these bytes.
    std::size_t bytes(std::span<const std::byte> bytes, GltfTarget target = GltfTarget::none);

    [[nodiscard]] std::span<const std::byte> buffer() const { return buffer_; }
    [[nodiscard]] const nlohmann::json& views() const { return views_; }
    [[nodiscard]] const nlohmann::json& accessors() const { return accessors_; }

private:
    struct Shape {
        std::string_view type; ///< "VEC3"
        int component;         ///< 5126 for float
        std::size_t count;
    };
    std::size_t accessor(std::span<const std::byte> data, const Shape& shape, GltfTarget target,
                         nlohmann::json bounds = {});
    template <class V>
    std::size_t of_floats(std::span<const V> values, std::string_view type, GltfTarget target, bool bounds);

    std::vector<std::byte> buffer_;
    nlohmann::json views_ = nlohmann::json::array(), accessors_ = nlohmann::json::array();
    std::unordered_multimap<std::size_t, std::size_t> view_by_hash_; ///< of the bytes and the target
    std::unordered_map<std::string, std::size_t> accessor_by_text_;  ///< of its JSON
};

/// A float as the shortest decimal number that is read as it.
[[nodiscard]] nlohmann::json gltf_number(float number);

} // namespace hachure::assets
