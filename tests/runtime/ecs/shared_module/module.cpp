#include <hachure/tests/runtime/ecs/shared_module/shared_components.h>

namespace hachure::test {
namespace {
struct OfOneFile {
    double other_than_in_the_program[3] = {};
};
} // namespace
} // namespace hachure::test

extern "C" __attribute__((visibility("default"))) void count_note(hachure::World& world, hachure::Entity entity) {
    using namespace hachure::test;
    const int length = static_cast<int>(world.get<SharedNote>(entity).text.size());
    world.add(entity, SharedCount{length * world.resource<SharedSettings>().step});
}

extern "C" __attribute__((visibility("default"))) hachure::detail::TypeId private_id() {
    return hachure::detail::component_id<hachure::test::OfOneFile>();
}
