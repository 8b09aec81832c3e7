// What the twins do to one entity at a time, and how often they do what.

#include <hachure/runtime/ecs/ecs_error.h>
#include <hachure/tests/runtime/ecs/world_model/model_twins.h>

#include <gtest/gtest.h>

namespace hachure::test::model {

void Twins::step() {
    const auto dice = pick(1000);
    if (dice < 100) return create();
    if (dice < 180) return create_with_some();
    if (dice < 250) return destroy();
    if (dice < 480) return add();
    if (dice < 600) return remove();
    if (dice < 720) return write();
    if (dice < 820) return set_parent();
    if (dice < 850) return clear_parent();
    if (dice < 910) return use_commands();
    if (dice < 930) return sweep();
    if (dice < 940) return sweep_with_each();
    if (dice < 970) return advance_tick();
    rarely();
}

void Twins::remember(Entity entity) {
    ASSERT_FALSE(model_.alive(entity));
    model_.nodes[entity];
    if (known_.size() < most_ + most_ / 2)
        known_.push_back(entity);
    else
        known_[pick(known_.size())] = entity;
}

void Twins::create() {
    if (!full()) remember(world_.create());
}

void Twins::create_with_some() {
    if (full()) return;
    const std::uint32_t n = any_number();
    const auto made = [&]<class... C>(std::type_identity<C>...) {
        const Entity entity = world_.create_with(C::make(n)...);
        remember(entity);
        (model_.put<C>(entity, n), ...);
    };
    using std::type_identity;
    switch (pick(6)) {
    case 0:
        return made(type_identity<Triple>(), type_identity<Text>());
    case 3:
        return made(type_identity<SparseMark>(), type_identity<Text>(), type_identity<SparseTriple>());
    case 4:
        return made(type_identity<SparseText>());
    case 1:
        return made(type_identity<Triple>(), type_identity<Mark>(), type_identity<Aligned64>());
    case 2:
        return made(type_identity<Large>(), type_identity<Unique>(), type_identity<Aligned32>());
    default:
        return made(type_identity<Mark>());
    }
}

void Twins::destroy() {
    const Entity entity = any();
    ASSERT_EQ(world_.destroy(entity), model_.alive(entity));
    if (model_.alive(entity)) model_.destroy(entity);
}

void Twins::add() {
    const Entity entity = any();
    const std::uint32_t n = any_number();
    with_kind(any_kind(), [&]<class C>() {
        if (!model_.alive(entity)) {
            EXPECT_THROW(world_.add(entity, C::make(n)), DeadEntity);
            return;
        }
        EXPECT_EQ(world_.add(entity, C::make(n)).number(), C::make(n).number());
        model_.put<C>(entity, n);
    });
}

void Twins::remove() {
    const Entity entity = any();
    const int kind = any_kind();
    const bool had = model_.has(entity, kind);
    with_kind(kind, [&]<class C>() { EXPECT_EQ(world_.remove<C>(entity), had); });
    if (had) model_.remove(entity, kind);
}

void Twins::write() {
    const Entity entity = any();
    const std::uint32_t n = any_number();
    with_kind(any_kind(), [&]<class C>() {
        C* found = world_.find_mutable<C>(entity);
        ASSERT_EQ(found != nullptr, model_.has(entity, kind_of<C>));
        if (!found) return;
        *found = C::make(n);
        model_.put<C>(entity, n);
    });
}

void Twins::set_parent() {
    const Entity child = any();
    const Entity parent = any();
    if (!model_.alive(child) || !model_.alive(parent)) {
        ASSERT_THROW(world_.set_parent(child, parent), DeadEntity);
    } else if (model_.contains(child, parent)) {
        ASSERT_THROW(world_.set_parent(child, parent), HierarchyCycle);
    } else {
        world_.set_parent(child, parent);
        model_.link(child, parent);
    }
}

void Twins::clear_parent() {
    const Entity child = any();
    world_.clear_parent(child);
    if (model_.alive(child)) model_.unlink(child);
}

} // namespace hachure::test::model
