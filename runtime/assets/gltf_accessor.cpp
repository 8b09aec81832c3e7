#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/gltf_accessor.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace hachure::assets {
namespace {

std::size_t component_bytes(ComponentType type) {
    switch (type) {
    case ComponentType::i8:
    case ComponentType::u8:
        return 1;
    case ComponentType::i16:
    case ComponentType::u16:
        return 2;
    case ComponentType::u32:
    case ComponentType::f32:
        return 4;
    }
    return 0;
}

// Columns of matrices start at multiples of 4 bytes (glTF 2.0, section 3.6.2.4).
std::size_t column_bytes(const AccessorShape& shape) {
    const std::size_t bytes = component_bytes(shape.type) * static_cast<std::size_t>(shape.rows);
    return shape.columns > 1 ? (bytes + 3) / 4 * 4 : bytes;
}

// Without the padding after the last column, which need not be in the buffer.
std::size_t element_bytes(const AccessorShape& shape) {
    return column_bytes(shape) * static_cast<std::size_t>(shape.columns - 1) +
           component_bytes(shape.type) * static_cast<std::size_t>(shape.rows);
}

/// Elements in a buffer, all of them inside it.
struct Elements {
    const std::byte* data = nullptr;
    std::size_t stride = 0;
};

template <class Component> Component load(const std::byte* from) {
    Component value;
    std::memcpy(&value, from, sizeof(value));
    return value;
}

template <class Component> float to_float(Component value, bool normalized) {
    if constexpr (std::is_floating_point_v<Component>) {
        return value;
    } else {
        const auto number = static_cast<float>(value);
        if (!normalized) return number;
        return std::max(number / static_cast<float>(std::numeric_limits<Component>::max()), -1.0f);
    }
}

template <class Component, class Out, class Convert>
void decode_element(const std::byte* from, const AccessorShape& shape, Out* out, Convert convert) {
    for (int column = 0; column < shape.columns; ++column, from += column_bytes(shape))
        for (int row = 0; row < shape.rows; ++row)
            *out++ = convert(load<Component>(from + static_cast<std::size_t>(row) * sizeof(Component)));
}

// Calls `visit` with a value of the C++ type that the component type stands for.
template <class Visit> void with_component(ComponentType type, Visit visit) {
    switch (type) {
    case ComponentType::i8:
        visit(std::int8_t{});
        break;
    case ComponentType::u8:
        visit(std::uint8_t{});
        break;
    case ComponentType::i16:
        visit(std::int16_t{});
        break;
    case ComponentType::u16:
        visit(std::uint16_t{});
        break;
    case ComponentType::u32:
        visit(std::uint32_t{});
        break;
    case ComponentType::f32:
        visit(float{});
        break;
    }
}

template <class Out, class Convert>
void decode_elements(const Elements& elements, const AccessorShape& shape, Out* out, Convert convert) {
    with_component(shape.type, [&](auto component) {
        for (std::size_t i = 0; i < shape.count; ++i, out += shape.components())
            decode_element<decltype(component)>(elements.data + i * elements.stride, shape, out, convert);
    });
}

/// Resolves an accessor to bytes and decodes all of it: the view, then what the sparse part replaces.
class Decoder {
public:
    Decoder(const GltfDocument& document, GltfBuffers& buffers, int accessor, const AccessorShape& shape)
        : document_(document), buffers_(buffers),
          accessor_(document.model->accessors[static_cast<std::size_t>(accessor)]), index_(accessor), shape_(shape) {}

    template <class Out, class Convert> void decode(std::span<Out> out, Convert convert) {
        const int view = accessor_.bufferView;
        if (view >= 0 && static_cast<std::size_t>(view) < document_.buffer_view_count) {
            const Elements elements = resolve(view, accessor_.byteOffset, shape_);
            const std::size_t packed = shape_.components() * sizeof(Out);
            if (std::is_same_v<Out, float> && shape_.type == ComponentType::f32 && elements.stride == packed)
                std::memcpy(out.data(), elements.data, out.size_bytes());
            else
                decode_elements(elements, shape_, out.data(), convert);
        }
        if (accessor_.sparse.isSparse) replace_sparse(out, convert);
    }

private:
    Elements resolve(int view, std::size_t offset, const AccessorShape& shape) {
        if (shape.count == 0) return {};
        const std::size_t element = element_bytes(shape);
        const std::size_t given = document_.model->bufferViews[static_cast<std::size_t>(view)].byteStride;
        const std::size_t packed = column_bytes(shape) * static_cast<std::size_t>(shape.columns);
        const std::size_t stride = given != 0 ? given : packed;
        if (stride < element) fail("has elements larger than its view's stride");
        const std::span<const std::byte> bytes = buffers_.view(view);
        // count, stride and offset are below 2^31: nothing here overflows.
        if (offset + stride * (shape.count - 1) + element > bytes.size()) fail("ends beyond its buffer view");
        return {bytes.data() + offset, stride};
    }

    template <class Out, class Convert> void replace_sparse(std::span<Out> out, Convert convert) {
        const auto& sparse = accessor_.sparse;
        AccessorShape index_shape;
        index_shape.count = static_cast<std::size_t>(sparse.count);
        index_shape.type = static_cast<ComponentType>(sparse.indices.componentType);
        AccessorShape value_shape = shape_;
        value_shape.count = index_shape.count;
        const Elements indices =
            resolve(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), index_shape);
        const Elements values =
            resolve(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), value_shape);

        with_component(shape_.type, [&](auto component) {
            for (std::size_t i = 0; i < index_shape.count; ++i) {
                std::uint32_t target = 0;
                with_component(index_shape.type, [&](auto type) {
                    target = static_cast<std::uint32_t>(load<decltype(type)>(indices.data + i * indices.stride));
                });
                if (target >= shape_.count) fail("has a sparse index beyond its count");
                decode_element<decltype(component)>(values.data + i * values.stride, shape_,
                                                    out.data() + target * shape_.components(), convert);
            }
        });
    }

    [[noreturn]] void fail(std::string_view fault) const { document_.fail(fault, accessor_pointer(index_)); }

    const GltfDocument& document_;
    GltfBuffers& buffers_;
    const tinygltf::Accessor& accessor_;
    int index_;
    const AccessorShape& shape_;
};

} // namespace

std::string accessor_pointer(int accessor) { return fmt::format("/accessors/{}", accessor); }

AccessorShape GltfAccessors::shape(int accessor) const {
    const tinygltf::Accessor& source = document_.model->accessors[static_cast<std::size_t>(accessor)];
    AccessorShape shape;
    shape.count = source.count;
    shape.type = static_cast<ComponentType>(source.componentType);
    shape.normalized = source.normalized;
    switch (source.type) {
    case TINYGLTF_TYPE_MAT2:
        shape.rows = shape.columns = 2;
        break;
    case TINYGLTF_TYPE_MAT3:
        shape.rows = shape.columns = 3;
        break;
    case TINYGLTF_TYPE_MAT4:
        shape.rows = shape.columns = 4;
        break;
    default:
        shape.rows = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source.type));
        break;
    }
    return shape;
}

std::size_t GltfAccessors::spend(int accessor, std::size_t bytes_per_element) {
    const std::size_t count = shape(accessor).count;
    budget_.spend(count, bytes_per_element, accessor_pointer(accessor));
    return count;
}

void GltfAccessors::decode_floats(int accessor, std::span<float> out) {
    const AccessorShape what = shape(accessor);
    HACHURE_ASSERT(out.size() == what.count * what.components(), "the vector type must fit the accessor");
    const bool normalized = what.normalized;
    Decoder(document_, buffers_, accessor, what).decode(out, [normalized](auto value) {
        return to_float(value, normalized);
    });
}

std::vector<float> GltfAccessors::floats(int accessor) {
    const std::size_t components = shape(accessor).components();
    std::vector<float> out(spend(accessor, components * sizeof(float)) * components);
    decode_floats(accessor, out);
    return out;
}

std::vector<std::uint32_t> GltfAccessors::integers(int accessor) {
    const AccessorShape what = shape(accessor);
    HACHURE_ASSERT(what.type == ComponentType::u8 || what.type == ComponentType::u16 || what.type == ComponentType::u32,
                   "the caller checks the component type");
    std::vector<std::uint32_t> out(spend(accessor, what.components() * sizeof(std::uint32_t)) * what.components());
    Decoder(document_, buffers_, accessor, what).decode(std::span<std::uint32_t>(out), [](auto value) {
        return static_cast<std::uint32_t>(value);
    });
    return out;
}

} // namespace hachure::assets
