#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace hachure::detail {

/// A vector of plain values for long lists that grow one by one: the system enlarges it in place where it can, without
/// the copies and the fresh memory that a std::vector takes each time it doubles.
template <class T> class GrowingArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    GrowingArray() = default;
    GrowingArray(GrowingArray&& other) noexcept
        : values_(std::exchange(other.values_, nullptr)), size_(std::exchange(other.size_, 0)),
          capacity_(std::exchange(other.capacity_, 0)) {}
    GrowingArray& operator=(GrowingArray&& other) noexcept {
        std::swap(values_, other.values_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        return *this;
    }
    ~GrowingArray() { std::free(values_); }

    std::size_t size() const { return size_; }
    const T* begin() const { return values_; }
    const T* end() const { return values_ + size_; }

    void push_back(const T& value) {
        const T copy = value;
        if (size_ == capacity_) reserve(size_ + 1);
        values_[size_++] = copy;
    }

    /// `more` is no part of this.
    void append(std::span<const T> more) {
        if (more.empty()) return;
        if (more.size() > capacity_ - size_) reserve(size_ + more.size());
        std::memcpy(values_ + size_, more.data(), more.size_bytes());
        size_ += more.size();
    }

    void erase_front(std::size_t count) {
        if (count == 0) return;
        size_ -= count;
        std::memmove(static_cast<void*>(values_), values_ + count, size_ * sizeof(T));
    }

private:
    [[gnu::cold, gnu::noinline]] void reserve(std::size_t least) {
        constexpr std::size_t smallest = 16;
        std::size_t capacity = capacity_ < smallest ? smallest : 2 * capacity_;
        if (capacity < least) capacity = least;
        void* larger = std::realloc(static_cast<void*>(values_), capacity * sizeof(T));
        if (!larger) throw std::bad_alloc();
        values_ = static_cast<T*>(larger);
        capacity_ = capacity;
    }

    T* values_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

} // namespace hachure::detail
