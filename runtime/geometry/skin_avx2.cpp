#include <hachure/runtime/geometry/skin_arguments.h>

#if defined(__x86_64__)
#include <immintrin.h>

// Everything from here on may use these instructions, but for what is included above.
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC target("avx2,fma")
#endif

namespace hachure::geometry::skin_loop {
namespace {

#define HACHURE_LANES 8
#include <hachure/runtime/geometry/lanes.h>
//
#include <hachure/runtime/geometry/skin_loop.h>

} // namespace

Loop avx2_loop(const Variant& variant) { return choose_loop(variant); }

} // namespace hachure::geometry::skin_loop

#if defined(__clang__)
#pragma clang attribute pop
#endif

#else

namespace hachure::geometry::skin_loop {

Loop avx2_loop(const Variant& variant) { return portable_loop(variant); }

} // namespace hachure::geometry::skin_loop

#endif
