// Needs the module that tests/CMakeLists.txt builds.
#ifdef HACHURE_TEST_MODULE

#include <hachure/tests/runtime/ecs/shared_module/shared_components.h>

#include <dlfcn.h>
#include <gtest/gtest.h>

namespace hachure::test {
namespace {

struct OfOneFile {
    int value = 0;
};

/// A shared library, built with hidden visibility, that takes what it lacks from this program. It stays loaded: worlds
/// may hold components whose code it has.
void* module() {
    static void* const handle = ::dlopen(HACHURE_TEST_MODULE, RTLD_NOW | RTLD_LOCAL);
    return handle;
}

template <class F> F* function(const char* name) { return reinterpret_cast<F*>(::dlsym(module(), name)); }

TEST(SharedModuleTest, SharesComponentsAndResourcesWithTheProgram) {
    ASSERT_TRUE(module()) << ::dlerror();
    auto* const count_note = function<CountNote>("count_note");
    ASSERT_TRUE(count_note);
    World world;
    world.set_resource(SharedSettings{10});
    const Entity entity = world.create_with(SharedNote{"seven.."});
    count_note(world, entity);
    ASSERT_TRUE(world.has<SharedCount>(entity));
    EXPECT_EQ(world.get<SharedCount>(entity).value, 70);
    EXPECT_EQ((world.query<const SharedNote, const SharedCount>().count()), 1u);
}

TEST(SharedModuleTest, KeepsTypesOfAnonymousNamespacesApart) {
    ASSERT_TRUE(module()) << ::dlerror();
    auto* const private_id = function<PrivateId>("private_id");
    ASSERT_TRUE(private_id);
    EXPECT_NE(private_id(), detail::component_id<OfOneFile>());
    EXPECT_EQ(private_id(), private_id());
}

} // namespace
} // namespace hachure::test

#endif
