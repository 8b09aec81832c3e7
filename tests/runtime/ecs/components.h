#pragma once

#include <memory>
#include <string>

/// Components of these tests: data, a second one, a tag, one that owns memory, one that can only be moved.
namespace hachure::test {

struct Position {
    double x = 0;
    double y = 0;
    bool operator==(const Position&) const = default;
};

struct Speed {
    double value = 1;
    bool operator==(const Speed&) const = default;
};

struct Hidden {};

struct Label {
    std::string text;
    bool operator==(const Label&) const = default;
};

struct Owner {
    std::unique_ptr<int> value;
};

} // namespace hachure::test
