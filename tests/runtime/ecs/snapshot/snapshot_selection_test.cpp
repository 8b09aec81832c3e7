#include <hachure/runtime/ecs/snapshot/snapshot_selection.h>

#include <gtest/gtest.h>

#include <random>

namespace hachure::detail {
namespace {

std::vector<std::uint32_t> through(const std::vector<std::uint32_t>& chosen, std::uint32_t of, Selection::Form form) {
    Bits bits(of);
    for (const std::uint32_t i : chosen) bits.set(i);
    std::vector<std::byte> bytes;
    ByteWriter out(bytes);
    write_selection(out, bits);
    ByteReader in(bytes, "test");
    const Selection selection = read_selection(in, of);
    in.expect_end();
    EXPECT_EQ(selection.count, chosen.size());
    EXPECT_EQ(selection.form, form) << chosen.size() << " of " << of;
    std::vector<std::uint32_t> result;
    for (SelectionCursor cursor(selection); !cursor.done(); cursor.next()) result.push_back(cursor.at());
    return result;
}

TEST(SnapshotSelectionTest, AnySubsetComesBackInTheSmallestForm) {
    std::mt19937 random(1);
    for (const std::uint32_t of : {1u, 7u, 8u, 63u, 64u, 65u, 1000u, 4096u, 5000u})
        for (const double share : {0.0, 0.001, 0.02, 0.5, 0.999, 1.0}) {
            std::vector<std::uint32_t> chosen;
            for (std::uint32_t i = 0; i < of; ++i)
                if (std::bernoulli_distribution(share)(random)) chosen.push_back(i);
            const bool listed = 4 + 4 * chosen.size() < (of + 7) / 8;
            const auto form = chosen.empty()        ? Selection::Form::none
                              : chosen.size() == of ? Selection::Form::all
                              : listed              ? Selection::Form::list
                                                    : Selection::Form::bits;
            EXPECT_EQ(through(chosen, of, form), chosen);
        }
    EXPECT_TRUE(through({}, 0, Selection::Form::none).empty());
}

TEST(SnapshotSelectionTest, NoSubsetIsRefused) {
    const auto read = [](std::vector<unsigned> values, std::uint32_t of) {
        std::vector<std::byte> bytes;
        for (const unsigned value : values) bytes.push_back(static_cast<std::byte>(value));
        ByteReader in(bytes, "test");
        read_selection(in, of);
    };
    EXPECT_NO_THROW(read({2, 0x05}, 3));
    EXPECT_THROW(read({2, 0x08}, 3), Error) << "a bit beyond the last";
    EXPECT_THROW(read({2}, 3), Error);
    EXPECT_NO_THROW(read({3, 2, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0}, 3));
    EXPECT_THROW(read({3, 2, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0}, 3), Error) << "not in order";
    EXPECT_THROW(read({3, 2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 3), Error) << "twice";
    EXPECT_THROW(read({3, 1, 0, 0, 0, 3, 0, 0, 0}, 3), Error) << "beyond the last";
    EXPECT_THROW(read({3, 255, 255, 255, 255}, 3), Error);
    EXPECT_THROW(read({4}, 3), Error) << "no such form";
}

} // namespace
} // namespace hachure::detail
