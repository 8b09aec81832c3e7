#include <hachure/runtime/geometry/skin_arguments.h>

namespace hachure::geometry::skin_loop {
namespace {

#define HACHURE_LANES 4
#include <hachure/runtime/geometry/lanes.h>
//
#include <hachure/runtime/geometry/skin_loop.h>

} // namespace

Loop portable_loop(const Variant& variant) { return choose_loop(variant); }

} // namespace hachure::geometry::skin_loop
