#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/debug_messages.h>

#include <fmt/format.h>

#include <utility>

namespace hachure::gpu {

Buffer::Buffer(std::size_t bytes, BufferUsage usage, std::string_view label) : bytes_(bytes), usage_(usage) {
    allocate(nullptr, label);
    clear();
}

Buffer::Buffer(std::span<const std::byte> data, BufferUsage usage, std::string_view label)
    : bytes_(data.size()), usage_(usage) {
    allocate(data.data(), label);
}

void Buffer::allocate(const void* data, std::string_view label) {
    HACHURE_ASSERT(bytes_ >= 1, "a buffer has at least one byte");
    GLuint name = 0;
    gl().CreateBuffers(1, &name);
    handle_ = detail::Handle<&Buffer::destroy>(name);
    label_object(GL_BUFFER, name, label);
    const GLbitfield flags = usage_ == BufferUsage::dynamic ? GL_DYNAMIC_STORAGE_BIT | GL_MAP_WRITE_BIT : 0;
    gl().NamedBufferStorage(name, static_cast<GLsizeiptr>(bytes_), data, flags);
    GLint immutable = GL_FALSE;
    gl().GetNamedBufferParameteriv(name, GL_BUFFER_IMMUTABLE_STORAGE, &immutable);
    if (immutable == GL_FALSE) throw Error(label, fmt::format("no memory for a buffer of {} bytes", bytes_));
}

void Buffer::destroy(GLuint name) { gl().DeleteBuffers(1, &name); }

void Buffer::update_bytes(std::span<const std::byte> data, std::size_t offset) {
    HACHURE_ASSERT(usage_ == BufferUsage::dynamic, "an immutable buffer is updated");
    HACHURE_ASSERT(offset <= bytes_ && data.size() <= bytes_ - offset, "an update past the end of a buffer");
    gl().NamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()), data.data());
}

void Buffer::read_bytes(std::span<std::byte> out, std::size_t offset) const {
    HACHURE_ASSERT(offset <= bytes_ && out.size() <= bytes_ - offset, "a read past the end of a buffer");
    gl().GetNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(out.size()), out.data());
}

BufferMapping Buffer::map(std::size_t offset, std::size_t bytes) {
    HACHURE_ASSERT(usage_ == BufferUsage::dynamic, "an immutable buffer is mapped");
    HACHURE_ASSERT(bytes >= 1 && offset <= bytes_ && bytes <= bytes_ - offset, "a mapping past the end of a buffer");
    void* memory = gl().MapNamedBufferRange(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                                            GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT);
    if (memory == nullptr) throw Error("OpenGL", fmt::format("a buffer of {} bytes could not be mapped", bytes_));
    return {name(), {static_cast<std::byte*>(memory), bytes}};
}

BufferMapping Buffer::map() { return map(0, bytes_); }

void Buffer::clear() { gl().ClearNamedBufferData(name(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr); }

void Buffer::bind_base(BufferBinding binding, GLuint index) const {
    gl().BindBufferBase(static_cast<GLenum>(binding), index, name());
}

void Buffer::bind(GLenum target) const { gl().BindBuffer(target, name()); }

BufferMapping::BufferMapping(BufferMapping&& other) noexcept
    : buffer_(std::exchange(other.buffer_, 0)), bytes_(std::exchange(other.bytes_, {})) {}

BufferMapping::~BufferMapping() {
    // GL_FALSE (contents lost in a display switch) does not happen on the systems at hand.
    if (buffer_ != 0) gl().UnmapNamedBuffer(buffer_);
}

} // namespace hachure::gpu
