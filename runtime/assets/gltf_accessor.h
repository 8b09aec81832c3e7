#pragma once

#include <hachure/runtime/assets/gltf_buffers.h>

#include <cstdint>

namespace hachure::assets {

enum class ComponentType : std::uint16_t { i8 = 5120, u8, i16, u16, u32 = 5125, f32 };

/// What an accessor says about its elements.
struct AccessorShape {
    std::size_t count = 0;
    ComponentType type = ComponentType::f32;
    bool normalized = false;
    int rows = 1;    ///< 1 to 4
    int columns = 1; ///< above 1 for matrices, which are stored by column

    [[nodiscard]] std::size_t components() const { return static_cast<std::size_t>(rows * columns); }
    [[nodiscard]] bool is_vector(int size) const { return columns == 1 && rows == size; }
};

/// Decodes accessors: interleaved or packed, sparse, compressed, normalised, of any component type. Everything is
/// bounds-checked against the buffers here; faults are hachure::Error with the accessor's JSON pointer.
class GltfAccessors {
public:
    /// All must outlive this.
    GltfAccessors(const GltfDocument& document, GltfBuffers& buffers, ByteBudget& budget)
        : document_(document), buffers_(buffers), budget_(budget) {}

    [[nodiscard]] AccessorShape shape(int accessor) const;

    /// All components as floats, `shape().components()` per element; integers are mapped to [0, 1] or [-1, 1] where the
    /// accessor is normalised (glTF 2.0, section 3.11) and keep their value where it is not. May be NaN or infinite.
    [[nodiscard]] std::vector<float> floats(int accessor);

    /// The same as vectors of `Vector::length()` floats, which must be the accessor's number of components.
    template <class Vector> [[nodiscard]] std::vector<Vector> vectors(int accessor) {
        std::vector<Vector> out(spend(accessor, sizeof(Vector)));
        decode_floats(accessor, {reinterpret_cast<float*>(out.data()), out.size() * (sizeof(Vector) / sizeof(float))});
        return out;
    }

    /// All components of an accessor of unsigned integers.
    [[nodiscard]] std::vector<std::uint32_t> integers(int accessor);

    /// Counts `count` elements that the caller is about to allocate; throws when a file of this size cannot have them.
    void spend_elements(std::uint64_t count, std::size_t element_bytes, const std::string& where) {
        budget_.spend(count, element_bytes, where);
    }

private:
    std::size_t spend(int accessor, std::size_t element_bytes);
    void decode_floats(int accessor, std::span<float> out);

    const GltfDocument& document_;
    GltfBuffers& buffers_;
    ByteBudget& budget_;
};

/// The JSON pointer of an accessor.
[[nodiscard]] std::string accessor_pointer(int accessor);

} // namespace hachure::assets
