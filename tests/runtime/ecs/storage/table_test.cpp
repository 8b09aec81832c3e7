// Tables by themselves: rows, chunks that empty and merge, where values stand.

#include <hachure/runtime/ecs/storage/table.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <new>
#include <random>
#include <string>
#include <vector>

namespace hachure {
namespace {

using detail::ChunkDirectory;
using detail::ComponentRecord;
using detail::Location;
using detail::Table;

struct Value {
    std::uint64_t number;
};
struct Text {
    std::string text;
};
struct Nothing {};
struct alignas(64) Wide {
    std::uint32_t number;
};
struct Block {
    std::array<std::uint32_t, 1500> numbers;
};

/// Where rows are, by entity.
struct Rows final : detail::RowIndex {
    std::map<Entity, Location> at;
    void set_row(Entity entity, Location row) override { at[entity] = row; }
};

/// A table of these components whose rows are all made from the index of their entity.
template <class... C> class Rig {
public:
    Rig() {
        records_ = {std::make_unique<ComponentRecord>(detail::component_info<C>())...};
        std::ranges::sort(records_, {}, [](const auto& record) { return record->info->id; });
        std::vector<ComponentRecord*> columns;
        for (const auto& record : records_) columns.push_back(record.get());
        table_ = std::make_unique<Table>(0, columns, directory_, rows_);
    }

    Table& table() { return *table_; }
    std::size_t size() const { return rows_.at.size(); }

    Entity append() {
        const Entity entity{next_++, 1};
        const Location at = table_->append(entity);
        (construct(static_cast<C*>(nullptr), at, entity.index), ...);
        for (std::size_t i = 0; i < table_->columns().size(); ++i)
            table_->set_ticks(at, i, 1 + entity.index, 2 + entity.index);
        rows_.at[entity] = at;
        return entity;
    }
    void drop(Entity entity) {
        const Location at = rows_.at.at(entity);
        rows_.at.erase(entity);
        table_->destroy_values(at);
        table_->drop_row(at);
    }

    /// Each row is where the index says, in one of the table's chunks, whole, with its ticks; there are no others.
    void check() {
        ASSERT_EQ(table_->size(), size());
        std::size_t rows = 0;
        for (const std::uint32_t chunk : table_->chunks()) {
            ASSERT_EQ(&directory_.table(chunk), table_.get());
            const auto entities = table_->entities(chunk);
            rows += entities.size();
            ASSERT_LE(entities.size(), table_->capacity());
            for (std::uint32_t row = 0; row < entities.size(); ++row) {
                const auto found = rows_.at.find(entities[row]);
                ASSERT_TRUE(found != rows_.at.end());
                ASSERT_EQ(found->second, (Location{chunk, row}));
                (check_value(static_cast<C*>(nullptr), found->second, entities[row].index), ...);
                for (std::size_t i = 0; i < table_->columns().size(); ++i) {
                    ASSERT_EQ(table_->ticks(chunk)[i].added(row), 1 + entities[row].index);
                    ASSERT_EQ(table_->ticks(chunk)[i].changed(row), 2 + entities[row].index);
                }
            }
        }
        ASSERT_EQ(rows, size());
    }

    /// A chunk is never kept for less than an eighth of its rows, but for the one that takes new ones.
    void check_chunks() {
        const std::size_t least = std::max<std::size_t>(table_->capacity() / 8, 1);
        ASSERT_LE(table_->chunks().size(), size() / least + 1);
        std::size_t small = 0;
        for (const std::uint32_t chunk : table_->chunks()) small += table_->entities(chunk).size() < least;
        ASSERT_LE(small, 1u);
    }

private:
    template <class T> T* value(Location at) {
        const std::uint32_t column = table_->column(detail::component_id<T>());
        auto* found = table_->value(at, column);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(found) % alignof(T), 0u);
        return reinterpret_cast<T*>(found);
    }
    void construct(Value*, Location at, std::uint32_t n) { new (value<Value>(at)) Value{n * 3ull}; }
    void construct(Text*, Location at, std::uint32_t n) {
        new (value<Text>(at)) Text{std::to_string(n) + std::string(n % 40, '.')};
    }
    void construct(Nothing*, Location at, std::uint32_t) { new (value<Nothing>(at)) Nothing; }
    void construct(Wide*, Location at, std::uint32_t n) { new (value<Wide>(at)) Wide{n}; }
    void construct(Block*, Location at, std::uint32_t n) { (new (value<Block>(at)) Block)->numbers.fill(n); }

    void check_value(Value*, Location at, std::uint32_t n) { ASSERT_EQ(value<Value>(at)->number, n * 3ull); }
    void check_value(Text*, Location at, std::uint32_t n) {
        ASSERT_EQ(value<Text>(at)->text, std::to_string(n) + std::string(n % 40, '.'));
    }
    void check_value(Nothing*, Location at, std::uint32_t) { ASSERT_NE(value<Nothing>(at), nullptr); }
    void check_value(Wide*, Location at, std::uint32_t n) { ASSERT_EQ(value<Wide>(at)->number, n); }
    void check_value(Block*, Location at, std::uint32_t n) {
        ASSERT_EQ(std::ranges::count(value<Block>(at)->numbers, n), 1500);
    }

    Rows rows_;
    ChunkDirectory directory_;
    std::array<std::unique_ptr<ComponentRecord>, sizeof...(C)> records_;
    std::unique_ptr<Table> table_;
    std::uint32_t next_ = 0;
};

template <class R> class TableTest : public testing::Test {
protected:
    R rig;

    std::vector<Entity> fill(std::size_t chunks, std::size_t more) {
        std::vector<Entity> result;
        while (result.size() < chunks * rig.table().capacity() + more) result.push_back(rig.append());
        return result;
    }
    void drop_all(const std::vector<Entity>& entities) {
        for (std::size_t i = 0; i < entities.size(); ++i) {
            rig.drop(entities[i]);
            rig.check_chunks();
            if (i % (entities.size() / 20 + 1) == 0) rig.check();
            if (this->HasFatalFailure()) FAIL() << "drop number " << i;
        }
        EXPECT_EQ(rig.table().size(), 0u);
        EXPECT_LE(rig.table().chunks().size(), 1u);
    }
};
using Rigs = testing::Types<Rig<>, Rig<Value>, Rig<Nothing>, Rig<Text, Nothing, Value>, Rig<Wide, Text>, Rig<Block>,
                            Rig<Block, Text, Wide, Nothing>>;
TYPED_TEST_SUITE(TableTest, Rigs);

TYPED_TEST(TableTest, KeepsItsRows) {
    EXPECT_EQ(this->rig.table().size(), 0u);
    this->fill(3, 1);
    this->rig.check();
    EXPECT_EQ(this->rig.table().chunks().size(), 4u);
}

TYPED_TEST(TableTest, DropsInOrder) { this->drop_all(this->fill(4, 1)); }

TYPED_TEST(TableTest, DropsFromTheLastOn) {
    auto entities = this->fill(4, 1);
    std::ranges::reverse(entities);
    this->drop_all(entities);
}

TYPED_TEST(TableTest, DropsAtRandom) {
    auto entities = this->fill(6, 1);
    std::ranges::shuffle(entities, std::mt19937(1));
    this->drop_all(entities);
}

TYPED_TEST(TableTest, DropsAllButOneOfEachChunk) {
    // The others gather.
    const auto entities = this->fill(6, 1);
    const std::uint32_t capacity = this->rig.table().capacity();
    std::vector<Entity> gone;
    for (std::size_t i = 0; i < entities.size(); ++i)
        if (i % capacity != 0) gone.push_back(entities[i]);
    for (const Entity entity : gone) this->rig.drop(entity);
    this->rig.check();
    this->rig.check_chunks();
    EXPECT_EQ(this->rig.table().size(), 7u);
}

TYPED_TEST(TableTest, ComesAndGoesAtRandom) {
    std::mt19937 random(2);
    std::vector<Entity> entities = this->fill(3, 0);
    for (int step = 0; step < 6000; ++step) {
        // Waves of growth and of decline.
        if (entities.empty() || (random() % 100 < (step / 1500 % 2 ? 30u : 60u) && entities.size() < 3000)) {
            entities.push_back(this->rig.append());
        } else {
            std::swap(entities[random() % entities.size()], entities.back());
            this->rig.drop(entities.back());
            entities.pop_back();
        }
        this->rig.check_chunks();
        if (step % 300 == 0) this->rig.check();
        if (this->HasFatalFailure()) FAIL() << "step " << step;
    }
}

TYPED_TEST(TableTest, ClearsAndBeginsAgain) {
    this->fill(2, 1);
    this->rig.table().clear();
    EXPECT_EQ(this->rig.table().size(), 0u);
    EXPECT_TRUE(this->rig.table().chunks().empty());
    TypeParam fresh;
    fresh.append();
    fresh.check();
}

TYPED_TEST(TableTest, OneThatComesAndGoesTakesOneChunk) {
    for (int i = 0; i < 100; ++i) {
        this->rig.drop(this->rig.append());
        ASSERT_EQ(this->rig.table().chunks().size(), 1u);
    }
    this->rig.check();
}

TYPED_TEST(TableTest, MakesRowsInBulk) {
    // One chunk at a time.
    Table& table = this->rig.table();
    const auto first = table.append_rows(5);
    EXPECT_EQ(first.count, std::min(table.capacity(), 5u));
    EXPECT_EQ(first.first.row(), 0u);
    const auto rest = table.append_rows(1'000'000);
    EXPECT_EQ(rest.count, table.capacity() > 5 ? table.capacity() - 5 : table.capacity());
    EXPECT_EQ(table.size(), first.count + rest.count);
    // Raw rows are dropped as if their values were gone.
    for (std::uint32_t i = rest.count; i-- > 0;) table.drop_row({rest.first.chunk(), rest.first.row() + i});
    EXPECT_EQ(table.size(), first.count);
    for (std::uint32_t i = first.count; i-- > 0;) table.drop_row({first.first.chunk(), i});
}

TEST(TableColumnsTest, KnowsItsComponents) {
    Rig<Value, Nothing> rig;
    Table& table = rig.table();
    EXPECT_TRUE(table.has(detail::component_id<Value>()) && table.has(detail::component_id<Nothing>()));
    EXPECT_FALSE(table.has(detail::component_id<Text>()));
    EXPECT_FALSE(table.has(1'000'000)) << "also for components that nobody told it of";
    EXPECT_EQ(table.columns().size(), 2u);
    const Entity entity = rig.append();
    table.widen(2000);
    EXPECT_FALSE(table.has(1999));
    rig.check();
    rig.drop(entity);
}

TEST(TableColumnsTest, ChunksOfAnotherTableAreUntouched) {
    Rig<Value> one;
    Rig<Text> other;
    for (int i = 0; i < 5000; ++i) {
        one.append();
        other.append();
    }
    one.table().clear();
    other.check();
}

} // namespace
} // namespace hachure
