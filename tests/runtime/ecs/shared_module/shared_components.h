#pragma once

#include <hachure/runtime/ecs/type_id.h>
#include <hachure/runtime/ecs/world.h>

#include <string>

/// What the test program and its shared module both know.
namespace hachure::test {

struct SharedNote {
    std::string text;
};

struct SharedCount {
    int value = 0;
};

struct SharedSettings {
    int step = 0;
};

} // namespace hachure::test

/// The module's functions, by which `dlsym` finds them.
extern "C" {
/// Reads SharedNote and the resource SharedSettings, and adds a SharedCount: the note's length times the step.
using CountNote = void(hachure::World& world, hachure::Entity entity);
/// The module's number for a type of its own anonymous namespace; the program has one of the same name.
using PrivateId = hachure::detail::TypeId();
}
