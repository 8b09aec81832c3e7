#pragma once

#include <hachure/runtime/error.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace hachure::detail {

// A snapshot is little-endian; values are copied as they lie in memory.
static_assert(std::endian::native == std::endian::little, "snapshots need a little-endian machine");

using Bytes = std::span<const std::byte>;

inline Bytes bytes_of(std::string_view text) { return std::as_bytes(std::span(text.data(), text.size())); }

/// Appends to a vector.
class ByteWriter {
public:
    explicit ByteWriter(std::vector<std::byte>& out) : out_(&out) {}

    std::size_t size() const { return out_->size(); }

    void bytes(Bytes bytes);

    template <class T>
    requires std::is_trivially_copyable_v<T>
    void number(T value) { bytes(std::as_bytes(std::span(&value, 1))); }

    template <class T> void numbers(std::span<const T> values) { bytes(std::as_bytes(values)); }

    /// At most 65535 bytes.
    void name(std::string_view text) {
        number(static_cast<std::uint16_t>(text.size()));
        bytes(bytes_of(text));
    }

    /// Replaces a number that was written at `at`.
    template <class T> void patch(std::size_t at, T value) { std::memcpy(out_->data() + at, &value, sizeof value); }

private:
    std::vector<std::byte>* out_;
};

/// Reads from a span that is not trusted. Throws Error(subject, ..., "byte N") instead of reading beyond its end.
class ByteReader {
public:
    /// `offset` is where `bytes` begin in what users call `subject`, which outlives the reader.
    ByteReader(Bytes bytes, std::string_view subject, std::size_t offset = 0)
        : bytes_(bytes), subject_(subject), offset_(offset) {}

    std::string_view subject() const { return subject_; }
    std::size_t left() const { return bytes_.size() - at_; }
    std::size_t offset() const { return offset_ + at_; }

    Bytes take(std::uint64_t count) {
        if (count > left()) fail("claims more than it holds");
        const Bytes result = bytes_.subspan(at_, static_cast<std::size_t>(count));
        at_ += result.size();
        return result;
    }

    /// What has been read since `left()` was `left_then`.
    Bytes taken_since(std::size_t left_then) const {
        const std::size_t begin = bytes_.size() - left_then;
        return bytes_.subspan(begin, at_ - begin);
    }

    template <class T> T number() {
        T value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }

    template <class T> std::vector<T> numbers(std::uint64_t count) {
        const Bytes bytes = take(count > left() ? count : count * sizeof(T)); // no overflow
        std::vector<T> values(bytes.size() / sizeof(T));
        if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }

    std::string_view name() {
        const Bytes bytes = take(number<std::uint16_t>());
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }

    void expect_end() const {
        if (left() != 0) fail("holds more than it says");
    }

    [[noreturn]] void fail(std::string_view fault) const {
        throw Error(subject_, fault, "byte " + std::to_string(offset()));
    }

private:
    Bytes bytes_;
    std::string_view subject_;
    std::size_t offset_;
    std::size_t at_ = 0;
};

} // namespace hachure::detail
