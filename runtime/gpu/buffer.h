#pragma once

#include <hachure/runtime/gpu/handle.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace hachure::gpu {

enum class BufferUsage : std::uint8_t {
    immutable, ///< written by its constructor, then by the GPU alone
    dynamic,   ///< update() and map() as well
};

/// Which indexed binding point bind_base means.
enum class BufferBinding : GLenum {
    uniform = GL_UNIFORM_BUFFER,
    storage = GL_SHADER_STORAGE_BUFFER,
    atomic_counter = GL_ATOMIC_COUNTER_BUFFER,
};

class BufferMapping;

/// GPU memory of fixed size (glCreateBuffers, glNamedBufferStorage). Sizes and offsets are in bytes.
class Buffer {
public:
    Buffer() = default;
    /// `bytes` >= 1, zeroed. Throws Error when the driver has no memory for it.
    Buffer(std::size_t bytes, BufferUsage usage, std::string_view label);
    /// With the contents of `data`, which is not empty.
    template <typename T>
    requires std::is_trivially_copyable_v<T> Buffer(std::span<const T> data, std::string_view label,
                                                    BufferUsage usage = BufferUsage::immutable)
        : Buffer(std::as_bytes(data), usage, label) {}

    /// Overwrites a part of a dynamic buffer (glNamedBufferSubData).
    template <typename T>
    requires std::is_trivially_copyable_v<T>
    void update(std::span<const T> data, std::size_t offset = 0) { update_bytes(std::as_bytes(data), offset); }

    /// Waits for the GPU and copies a part out (glGetNamedBufferSubData).
    template <typename T>
    requires(std::is_trivially_copyable_v<T> && !std::is_const_v<T>) void read(std::span<T> out,
                                                                               std::size_t offset = 0) const {
        read_bytes(std::as_writable_bytes(out), offset);
    }

    /// Memory to write a part of a dynamic buffer through; its old contents are gone (glMapNamedBufferRange). The
    /// buffer may not be used, moved or destroyed meanwhile. Throws Error when the driver refuses.
    [[nodiscard]] BufferMapping map(std::size_t offset, std::size_t bytes);
    /// All of it.
    [[nodiscard]] BufferMapping map();

    /// Sets all of it to zero (glClearNamedBufferData).
    void clear();

    /// glBindBufferBase.
    void bind_base(BufferBinding binding, GLuint index) const;
    /// To a point without index, such as GL_DRAW_INDIRECT_BUFFER (glBindBuffer).
    void bind(GLenum target) const;

    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    [[nodiscard]] BufferUsage usage() const { return usage_; }
    [[nodiscard]] GLuint name() const { return handle_.get(); }
    [[nodiscard]] explicit operator bool() const { return name() != 0; }

private:
    Buffer(std::span<const std::byte> data, BufferUsage usage, std::string_view label);
    void allocate(const void* data, std::string_view label);
    void update_bytes(std::span<const std::byte> data, std::size_t offset);
    void read_bytes(std::span<std::byte> out, std::size_t offset) const;
    static void destroy(GLuint name);

    detail::Handle<&Buffer::destroy> handle_;
    std::size_t bytes_ = 0;
    BufferUsage usage_ = BufferUsage::immutable;
};

/// Mapped memory of a buffer, unmapped when it goes (glUnmapNamedBuffer).
class BufferMapping {
public:
    BufferMapping(BufferMapping&& other) noexcept;
    BufferMapping& operator=(BufferMapping&&) = delete;
    ~BufferMapping();

    /// Write-only: reading it is slow or undefined.
    [[nodiscard]] std::span<std::byte> bytes() const { return bytes_; }

private:
    friend class Buffer;
    BufferMapping(GLuint buffer, std::span<std::byte> bytes) : buffer_(buffer), bytes_(bytes) {}

    GLuint buffer_;
    std::span<std::byte> bytes_;
};

} // namespace hachure::gpu
