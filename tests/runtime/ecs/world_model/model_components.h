#pragma once

#include <hachure/runtime/ecs/storage.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

/// The kinds of component that the random operations use: each is made from a number and gives that number back.
namespace hachure::test::model {

/// What `Counted` has seen so far.
struct Instances {
    static inline std::int64_t live = 0;
    static inline std::int64_t faults = 0; ///< uses and destructions of what was not alive
};

/// Counts itself, and notices when it is used after its end or destroyed twice.
class Counted {
public:
    Counted() { ++Instances::live; }
    Counted(Counted&& other) noexcept : Counted() { other.expect_alive(); }
    Counted(const Counted& other) : Counted() { other.expect_alive(); }
    Counted& operator=(Counted&& other) noexcept { return *this = std::as_const(other); }
    Counted& operator=(const Counted& other) noexcept {
        expect_alive();
        other.expect_alive();
        return *this;
    }
    ~Counted() {
        expect_alive();
        life_ = 0;
        --Instances::live;
    }

private:
    static constexpr std::uint32_t alive = 0x600d'beef;

    void expect_alive() const { Instances::faults += life_ == alive ? 0 : 1; }

    volatile std::uint32_t life_ = alive; ///< volatile, or the last write would be left out
};

/// Trivial, 12 bytes.
struct Triple {
    float x = 0.0f, y = 0.0f, z = 0.0f;

    static Triple make(std::uint32_t n) {
        const auto value = static_cast<float>(n % 4096);
        return {value, -value, 1.0f};
    }
    std::uint32_t number() const { return x == -y && z == 1.0f ? static_cast<std::uint32_t>(x) : ~0u; }
};

/// Empty.
struct Mark {
    static Mark make(std::uint32_t) { return {}; }
    std::uint32_t number() const { return 0; }
};

/// Two that want more alignment than the heap gives.
struct alignas(32) Aligned32 {
    std::array<float, 8> values{};

    static Aligned32 make(std::uint32_t n) {
        Aligned32 result;
        result.values.back() = static_cast<float>(n % 4096);
        return result;
    }
    std::uint32_t number() const {
        const bool placed = reinterpret_cast<std::uintptr_t>(this) % 32 == 0;
        return placed ? static_cast<std::uint32_t>(values.back()) : ~0u;
    }
};

struct alignas(64) Aligned64 {
    std::uint32_t value = 0;

    static Aligned64 make(std::uint32_t n) {
        Aligned64 result;
        result.value = n;
        return result;
    }
    std::uint32_t number() const { return reinterpret_cast<std::uintptr_t>(this) % 64 == 0 ? value : ~0u; }
};

/// Can only be moved.
struct Unique {
    std::unique_ptr<std::uint32_t> value;
    Counted counted;

    static Unique make(std::uint32_t n) { return {std::make_unique<std::uint32_t>(n), {}}; }
    std::uint32_t number() const { return value ? *value : ~0u; }
};

/// Owns memory, or, when short, points into itself.
struct Text {
    std::string text;
    Counted counted;

    static Text make(std::uint32_t n) { return {std::to_string(n) + std::string(n % 40, '.'), {}}; }
    std::uint32_t number() const { return text.empty() ? ~0u : static_cast<std::uint32_t>(std::stoul(text)); }
};

/// Larger than a page holds many of.
struct Large {
    std::array<std::uint32_t, 512> values{};

    static Large make(std::uint32_t n) {
        Large result;
        result.values.fill(n);
        return result;
    }
    std::uint32_t number() const { return values.front() == values.back() ? values[256] : ~0u; }
};

/// Three with sparse storage: data, a tag, and one that owns memory.
struct SparseTriple : Triple {
    static constexpr auto storage = Storage::sparse;
    static SparseTriple make(std::uint32_t n) { return {Triple::make(n)}; }
};

struct SparseMark : Mark {
    static constexpr auto storage = Storage::sparse;
    static SparseMark make(std::uint32_t) { return {}; }
};

struct SparseText : Text {
    static constexpr auto storage = Storage::sparse;
    static SparseText make(std::uint32_t n) { return {Text::make(n)}; }
};

inline constexpr int kinds = 10;

/// The kind of a component.
template <class C> inline constexpr int kind_of = -1;
template <> inline constexpr int kind_of<Triple> = 0;
template <> inline constexpr int kind_of<Mark> = 1;
template <> inline constexpr int kind_of<Aligned32> = 2;
template <> inline constexpr int kind_of<Aligned64> = 3;
template <> inline constexpr int kind_of<Unique> = 4;
template <> inline constexpr int kind_of<Text> = 5;
template <> inline constexpr int kind_of<Large> = 6;
template <> inline constexpr int kind_of<SparseTriple> = 7;
template <> inline constexpr int kind_of<SparseMark> = 8;
template <> inline constexpr int kind_of<SparseText> = 9;

/// Calls `f.template operator()<C>()` for the component of a kind, 0 to kinds - 1.
template <class F> decltype(auto) with_kind(int kind, F&& f) {
    switch (kind) {
    case 0:
        return f.template operator()<Triple>();
    case 1:
        return f.template operator()<Mark>();
    case 2:
        return f.template operator()<Aligned32>();
    case 3:
        return f.template operator()<Aligned64>();
    case 4:
        return f.template operator()<Unique>();
    case 5:
        return f.template operator()<Text>();
    case 6:
        return f.template operator()<Large>();
    case 7:
        return f.template operator()<SparseTriple>();
    case 8:
        return f.template operator()<SparseMark>();
    default:
        return f.template operator()<SparseText>();
    }
}

} // namespace hachure::test::model
