#pragma once

#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/handle.h>

#include <cstdint>
#include <string_view>

namespace hachure::gpu {

/// How a shader sees the values of an attribute.
enum class AttributeKind : std::uint8_t {
    floating,   ///< as float: floats as they are, integers by their value
    normalized, ///< as float: integers mapped to 0..1 or -1..1
    integer,    ///< as int or uint
};

/// One input of a vertex shader.
struct VertexAttribute {
    GLuint location = 0;    ///< layout(location) in the shader
    int components = 3;     ///< 1..4
    GLenum type = GL_FLOAT; ///< of a component in memory
    AttributeKind kind = AttributeKind::floating;
    GLuint offset = 0;  ///< bytes from the start of a vertex
    GLuint binding = 0; ///< which vertex buffer
};

/// Where vertices come from (glCreateVertexArrays). It does not own its buffers, which must outlive the draws.
class VertexArray {
public:
    VertexArray() = default;
    explicit VertexArray(std::string_view label);

    /// Enables an attribute (glEnableVertexArrayAttrib, glVertexArrayAttribFormat, glVertexArrayAttribBinding).
    void set_attribute(const VertexAttribute& attribute);
    /// Vertices `stride` bytes apart from `offset` on; `divisor` > 0 advances once per that many instances
    /// (glVertexArrayVertexBuffer, glVertexArrayBindingDivisor).
    void set_vertex_buffer(GLuint binding, const Buffer& buffer, GLsizei stride, std::size_t offset = 0,
                           GLuint divisor = 0);
    /// glVertexArrayElementBuffer.
    void set_index_buffer(const Buffer& buffer);

    /// glBindVertexArray.
    void bind() const;

    [[nodiscard]] GLuint name() const { return handle_.get(); }
    [[nodiscard]] explicit operator bool() const { return name() != 0; }

private:
    static void destroy(GLuint name);
    detail::Handle<&VertexArray::destroy> handle_;
};

} // namespace hachure::gpu
