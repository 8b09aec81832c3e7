#pragma once

#include <hachure/runtime/assets/ply_header.h>
#include <hachure/runtime/assets/text_scanner.h>

#include <bit>
#include <cstring>

/// Where the values of a PLY file come from, one after the other. Both sources have the same members, for templates.
namespace hachure::assets {

class PlyTextSource {
public:
    PlyTextSource(const std::filesystem::path& file, std::string_view text, std::size_t body) : scan_(file, text) {
        scan_.advance(body);
    }

    float read_float(PlyType) {
        scan_.skip_space();
        float value = 0.0f;
        if (!scan_.read(value) || !scan_.at_word_end()) fail_number();
        return value;
    }

    std::int64_t read_integer(PlyType) {
        scan_.skip_space();
        std::int64_t value = 0;
        if (!scan_.read(value) || !scan_.at_word_end()) fail_number();
        return value;
    }

    void skip(PlyType, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            scan_.skip_space();
            if (scan_.at_end()) fail_number();
            static_cast<void>(scan_.word());
        }
    }

    /// Whether that many values may still come.
    [[nodiscard]] bool holds(PlyType, std::uint64_t count) const { return count <= scan_.remaining() / 2 + 1; }

    [[noreturn]] void fail(std::string_view fault) const { scan_.fail(fault); }

private:
    [[noreturn]] void fail_number() const { scan_.fail(scan_.at_end() ? "truncated" : "expected a number"); }
    TextScanner scan_;
};

template <bool swap> class PlyBinarySource {
public:
    PlyBinarySource(const std::filesystem::path& file, std::string_view text, std::size_t body)
        : file_(file), begin_(text.data()), at_(text.data() + body), end_(text.data() + text.size()) {}

    float read_float(PlyType type) {
        switch (type) {
        case PlyType::f32:
            return load<float>();
        case PlyType::f64:
            return static_cast<float>(load<double>());
        default:
            return static_cast<float>(read_integer(type));
        }
    }

    /// Values that are no integer give -1, which no count or index is.
    std::int64_t read_integer(PlyType type) {
        switch (type) {
        case PlyType::i8:
            return load<std::int8_t>();
        case PlyType::u8:
            return load<std::uint8_t>();
        case PlyType::i16:
            return load<std::int16_t>();
        case PlyType::u16:
            return load<std::uint16_t>();
        case PlyType::i32:
            return load<std::int32_t>();
        case PlyType::u32:
            return load<std::uint32_t>();
        default:
            break;
        }
        const double value = type == PlyType::f32 ? static_cast<double>(load<float>()) : load<double>();
        return value >= 0.0 && value < 0x1p32 && value == std::floor(value) ? static_cast<std::int64_t>(value) : -1;
    }

    void skip(PlyType type, std::size_t count) {
        if (!holds(type, count)) fail("truncated");
        at_ += count * ply_size(type);
    }

    [[nodiscard]] bool holds(PlyType type, std::uint64_t count) const {
        return count <= static_cast<std::uint64_t>(end_ - at_) / ply_size(type);
    }

    [[noreturn]] void fail(std::string_view fault) const {
        throw Error(file_.string(), fault, "byte " + std::to_string(at_ - begin_));
    }

private:
    template <class T> T load() {
        if (static_cast<std::size_t>(end_ - at_) < sizeof(T)) fail("truncated");
        char bytes[sizeof(T)];
        std::memcpy(bytes, at_, sizeof(T));
        if constexpr (swap) std::reverse(bytes, bytes + sizeof(T));
        at_ += sizeof(T);
        T value;
        std::memcpy(&value, bytes, sizeof(T));
        return value;
    }

    const std::filesystem::path& file_;
    const char* begin_;
    const char* at_;
    const char* end_;
};

} // namespace hachure::assets
