#include <hachure/runtime/gpu/debug_messages.h>
#include <hachure/runtime/gpu/vertex_array.h>

namespace hachure::gpu {

VertexArray::VertexArray(std::string_view label) {
    GLuint name = 0;
    gl().CreateVertexArrays(1, &name);
    handle_ = detail::Handle<&VertexArray::destroy>(name);
    label_object(GL_VERTEX_ARRAY, name, label);
}

void VertexArray::destroy(GLuint name) { gl().DeleteVertexArrays(1, &name); }

void VertexArray::set_attribute(const VertexAttribute& attribute) {
    gl().EnableVertexArrayAttrib(name(), attribute.location);
    if (attribute.kind == AttributeKind::integer) {
        gl().VertexArrayAttribIFormat(name(), attribute.location, attribute.components, attribute.type,
                                      attribute.offset);
    } else {
        const GLboolean normalized = attribute.kind == AttributeKind::normalized ? GL_TRUE : GL_FALSE;
        gl().VertexArrayAttribFormat(name(), attribute.location, attribute.components, attribute.type, normalized,
                                     attribute.offset);
    }
    gl().VertexArrayAttribBinding(name(), attribute.location, attribute.binding);
}

void VertexArray::set_vertex_buffer(GLuint binding, const Buffer& buffer, GLsizei stride, std::size_t offset,
                                    GLuint divisor) {
    gl().VertexArrayVertexBuffer(name(), binding, buffer.name(), static_cast<GLintptr>(offset), stride);
    gl().VertexArrayBindingDivisor(name(), binding, divisor);
}

void VertexArray::set_index_buffer(const Buffer& buffer) { gl().VertexArrayElementBuffer(name(), buffer.name()); }

void VertexArray::bind() const { gl().BindVertexArray(name()); }

} // namespace hachure::gpu
