#pragma once

#include <hachure/runtime/ecs/storage.h>

#include <string>

/// Components with sparse storage: data, a tag, one that owns memory.
namespace hachure::test {

struct Heat {
    static constexpr auto storage = Storage::sparse;
    double value = 0;
    bool operator==(const Heat&) const = default;
};

struct Chosen {
    static constexpr auto storage = Storage::sparse;
};

struct Note {
    static constexpr auto storage = Storage::sparse;
    std::string text;
    bool operator==(const Note&) const = default;
};

} // namespace hachure::test
