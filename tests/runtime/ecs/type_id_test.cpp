#include <hachure/runtime/ecs/type_id.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace hachure::test {

template <class T> struct Wrapped {};

struct Named {
    struct Inner {};
    auto local() const {
        struct Local {};
        return Local{};
    }
};

namespace {

struct Private {};

/// The number that a second library would get for T.
template <class T> detail::TypeId elsewhere() {
    const std::string copy = typeid(T).name(); // at another address, as in another library
    return detail::next_type_id(detail::TypeFamily::component, {copy, sizeof(T), alignof(T)});
}

TEST(TypeIdTest, ATypeHasOneNumber) {
    EXPECT_EQ(elsewhere<Position>(), detail::component_id<Position>());
    EXPECT_EQ(elsewhere<Named::Inner>(), detail::component_id<Named::Inner>());
    EXPECT_EQ(elsewhere<Wrapped<Label>>(), detail::component_id<Wrapped<Label>>());
    EXPECT_EQ(elsewhere<std::function<void(Label&)>>(), detail::component_id<std::function<void(Label&)>>());
    EXPECT_NE(detail::component_id<Wrapped<Label>>(), detail::component_id<Wrapped<Position>>());
    EXPECT_NE(detail::component_id<Position>(), detail::component_id<Label>());
}

TEST(TypeIdTest, FamiliesAreCountedApart) {
    const auto id = [](detail::TypeFamily family, const char* name) {
        return detail::next_type_id(family, {name, 1, 1});
    };
    const auto component = id(detail::TypeFamily::component, "3One");
    const auto resource = id(detail::TypeFamily::resource, "3One");
    EXPECT_EQ(id(detail::TypeFamily::component, "3Two"), component + 1);
    EXPECT_EQ(id(detail::TypeFamily::resource, "3Two"), resource + 1);
    EXPECT_EQ(id(detail::TypeFamily::resource, "3One"), resource);
}

TEST(TypeIdTest, TypesOfOneFileAreNeverMerged) {
    struct Local {};
    const auto lambda = [] {};
    using Lambda = decltype(lambda);
    EXPECT_NE(elsewhere<Private>(), detail::component_id<Private>());
    EXPECT_NE(elsewhere<Wrapped<Private>>(), detail::component_id<Wrapped<Private>>());
    EXPECT_NE(elsewhere<Local>(), detail::component_id<Local>());
    EXPECT_NE(elsewhere<Wrapped<Local>>(), detail::component_id<Wrapped<Local>>());
    EXPECT_NE(elsewhere<Lambda>(), detail::component_id<Lambda>());
    using LocalOfMember = decltype(Named{}.local());
    EXPECT_NE(elsewhere<LocalOfMember>(), detail::component_id<LocalOfMember>());
    // Within the file each keeps its number.
    EXPECT_EQ(detail::component_id<Private>(), detail::component_id<Private>());
}

TEST(TypeIdTest, ThreadsAgree) {
    constexpr int threads = 8, types = 64;
    std::array<std::vector<detail::TypeId>, threads> seen;
    std::vector<std::thread> running;
    for (auto& mine : seen)
        running.emplace_back([&mine] {
            for (int i = 0; i < types; ++i) {
                const std::string name = "7Thread" + std::to_string(i);
                mine.push_back(detail::next_type_id(detail::TypeFamily::component, {name, 4, 4}));
            }
        });
    for (std::thread& thread : running) thread.join();
    for (const auto& mine : seen) EXPECT_EQ(mine, seen.front());
    EXPECT_EQ(std::set(seen.front().begin(), seen.front().end()).size(), static_cast<std::size_t>(types));
}

TEST(TypeIdDeathTest, TwoLayoutsOfOneNameAssert) {
    const auto id = [](std::size_t size, std::size_t alignment) {
        return detail::next_type_id(detail::TypeFamily::component, {"N7hachure6LayoutE", size, alignment});
    };
    id(8, 4);
    EXPECT_DEATH(id(12, 4), "hachure::Layout has 8 bytes aligned to 4 in one library and 12 aligned to 4 in another");
    EXPECT_DEATH(id(8, 8), "a type has one layout");
}

} // namespace
} // namespace hachure::test
