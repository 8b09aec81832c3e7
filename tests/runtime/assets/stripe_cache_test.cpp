#include <hachure/runtime/assets/stripe_cache.h>
#include <hachure/runtime/assets/stripe_file.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <thread>
#include <vector>

namespace hachure::assets {
namespace {

namespace fs = std::filesystem;

/// A variable of the environment with another value, or without one, while this lives.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        if (value != nullptr)
            ::setenv(name, value, 1);
        else
            ::unsetenv(name);
    }
    ~Variable() {
        if (old_)
            ::setenv(name_, old_->c_str(), 1);
        else
            ::unsetenv(name_);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    std::optional<std::string> old_;
};

TEST(UserCacheFolder, IsWhereTheEnvironmentSays) {
    Variable home("HOME", "/home/somebody"), shared("XDG_CACHE_HOME", nullptr), own("HACHURE_CACHE", nullptr);
    EXPECT_EQ(user_cache_folder(), fs::path("/home/somebody/.cache/hachure"));
    {
        Variable relative("XDG_CACHE_HOME", "here");
        EXPECT_EQ(user_cache_folder(), fs::path("/home/somebody/.cache/hachure"));
        Variable absolute("XDG_CACHE_HOME", "/caches");
        EXPECT_EQ(user_cache_folder(), fs::path("/caches/hachure"));
        Variable named("HACHURE_CACHE", "/elsewhere");
        EXPECT_EQ(user_cache_folder(), fs::path("/elsewhere"));
        Variable off("HACHURE_CACHE", "off");
        EXPECT_EQ(user_cache_folder(), std::nullopt);
    }
    Variable homeless("HOME", nullptr);
    EXPECT_EQ(user_cache_folder(), std::nullopt);
}

class StripeCache : public ::testing::Test {
protected:
    [[nodiscard]] geometry::StripeMesh get(std::uintmax_t limit = stripe_cache_bytes) const {
        return cached_stripe_mesh(shape_.positions, shape_.normals, shape_.indices, settings_, folder_.path(), limit);
    }
    [[nodiscard]] geometry::StripeMesh computed() const {
        return geometry::make_stripe_mesh(shape_.positions, shape_.normals, shape_.indices, settings_);
    }
    [[nodiscard]] StripeKey key() const {
        return stripe_key(shape_.positions, shape_.normals, shape_.indices, settings_);
    }
    [[nodiscard]] fs::path file() const { return folder_ / "stripes" / stripe_file_name(key()); }
    [[nodiscard]] std::string bytes() const { return test::file_text(file()); }
    void write(const std::string& bytes) const {
        std::ofstream(file(), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }

    test::TempFolder folder_;
    geometry::Shape shape_ = geometry::icosphere(1.0, 2);
    geometry::StripeSettings settings_;
};

TEST_F(StripeCache, GivesWhatWasComputed) {
    const geometry::StripeMesh mesh = computed();
    EXPECT_EQ(get(), mesh);
    EXPECT_EQ(folder_.listing().size(), 2u); // the folder and one file
    // It is read: another mesh in its place, sound by all that can be checked, is what comes back.
    geometry::StripeMesh other = mesh;
    for (float& u : other.coordinate) u = 0.25f;
    const std::vector<std::byte> forged = stripe_file_bytes(key(), other);
    write({reinterpret_cast<const char*>(forged.data()), forged.size()});
    EXPECT_EQ(get(), other);
}

TEST_F(StripeCache, TellsArgumentsApart) {
    const StripeKey before = key();
    settings_.sets = std::nextafter(settings_.sets, 2.0);
    EXPECT_NE(key(), before);
    settings_ = {};
    shape_.positions[7].x = std::nextafter(shape_.positions[7].x, 2.0f);
    EXPECT_NE(key(), before);
    shape_ = geometry::icosphere(1.0, 2);
    std::swap(shape_.indices[0], shape_.indices[1]);
    EXPECT_NE(key(), before);
    shape_ = geometry::icosphere(1.0, 2);
    shape_.normals[0] = -shape_.normals[0];
    EXPECT_NE(key(), before);
    shape_ = geometry::icosphere(1.0, 2);
    EXPECT_EQ(key(), before);
}

TEST_F(StripeCache, ComputesAgainWhatIsDamaged) {
    const geometry::StripeMesh mesh = get();
    const std::string sound = bytes();
    ASSERT_GT(sound.size(), 100u);
    std::vector<std::string> damaged = {"",
                                        "x",
                                        sound.substr(0, 40),
                                        sound.substr(0, sound.size() - 1),
                                        sound + '\0',
                                        std::string(sound.size(), '\0'),
                                        std::string(sound.size(), '\xff')};
    for (std::size_t at = 0; at < sound.size(); at += 1 + sound.size() / 60) {
        damaged.push_back(sound);
        damaged.back()[at] = static_cast<char>(damaged.back()[at] ^ 0x10);
    }
    for (const std::string& content : damaged) {
        write(content);
        EXPECT_EQ(get(), mesh);
        EXPECT_EQ(bytes(), sound); // and it was replaced
    }
}

TEST_F(StripeCache, BelievesNoFileThatIsWrong) {
    // With a valid hash: what a reader must not trust.
    const geometry::StripeMesh mesh = computed();
    const auto refused = [&](auto change) {
        geometry::StripeMesh wrong = mesh;
        change(wrong);
        return !read_stripe_file(stripe_file_bytes(key(), wrong), key(), shape_.positions.size(), shape_.indices);
    };
    using Mesh = geometry::StripeMesh;
    EXPECT_FALSE(refused([](Mesh&) {}));
    EXPECT_TRUE(refused([](Mesh& m) { m.coordinate[3] = std::nanf(""); }));
    EXPECT_TRUE(refused([](Mesh& m) { m.coordinate[3] = std::numeric_limits<float>::infinity(); }));
    EXPECT_TRUE(refused([](Mesh& m) { m.weight[3] = 1.5f; }));
    EXPECT_TRUE(refused([](Mesh& m) { m.weight[3] = std::nanf(""); }));
    EXPECT_TRUE(refused([](Mesh& m) { m.lean[3] *= 1.1f; }));
    EXPECT_TRUE(refused([](Mesh& m) { m.lean[3].x = std::nanf(""); }));
    EXPECT_TRUE(refused([](Mesh& m) { m.clarity[3] = -0.5f; }));
    EXPECT_TRUE(refused([](Mesh& m) { m.mirrored[0] = 2; }));
    EXPECT_TRUE(refused([](Mesh& m) { m.stands_for[0] = 1000000; }));
    EXPECT_TRUE(refused([](Mesh& m) { m.source_vertex[0] = 1; }));
    EXPECT_TRUE(refused([](Mesh& m) { m.source_vertex.back() = 1000000; }));
    EXPECT_TRUE(refused([](Mesh& m) { m.indices[0] = 1000000; }));
    EXPECT_TRUE(refused([](Mesh& m) { std::swap(m.indices[0], m.indices[1]); }));
    EXPECT_TRUE(refused([](Mesh& m) { m.indices.pop_back(); }));
    StripeKey other = key();
    ++other[1];
    EXPECT_FALSE(read_stripe_file(stripe_file_bytes(other, mesh), key(), shape_.positions.size(), shape_.indices));
}

TEST_F(StripeCache, OldFilesGo) {
    const fs::path folder = folder_ / "stripes";
    (void)get();
    const std::uintmax_t size = fs::file_size(file());
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
    const fs::path first = file();
    fs::last_write_time(first, old);
    folder_.write("stripes/older", std::string(size, 'x'));
    fs::last_write_time(folder / "older", old - std::chrono::hours(1));
    (void)get(3 * size); // a hit: used just now
    EXPECT_GT(fs::last_write_time(first), old);
    settings_.sets = 2.0;
    (void)get(2 * size + size / 2);
    EXPECT_FALSE(fs::exists(folder / "older"));
    EXPECT_TRUE(fs::exists(first));
    EXPECT_TRUE(fs::exists(file()));
    settings_.sets = 3.0;
    (void)get(size / 2); // it alone is too large
    EXPECT_FALSE(fs::exists(file()));
}

TEST_F(StripeCache, NoFolderIsFine) {
    const geometry::StripeMesh mesh = computed();
    EXPECT_EQ(cached_stripe_mesh(shape_.positions, shape_.normals, shape_.indices, settings_, std::nullopt), mesh);
    const fs::path blocked = folder_.write("file", "not a folder");
    EXPECT_EQ(cached_stripe_mesh(shape_.positions, shape_.normals, shape_.indices, settings_, blocked), mesh);
    EXPECT_EQ(cached_stripe_mesh(shape_.positions, shape_.normals, shape_.indices, settings_, "/dev/null/x"), mesh);
    EXPECT_EQ(folder_.listing(), std::set<std::string>{"file"});
}

TEST_F(StripeCache, ManyAtOnceDoNotDisturbEachOther) {
    const geometry::StripeMesh mesh = computed();
    std::vector<std::thread> threads;
    std::vector<int> right(8, 0);
    for (std::size_t i = 0; i < right.size(); ++i)
        threads.emplace_back([&, i] {
            for (int round = 0; round < 10; ++round) {
                if (get() == mesh) ++right[i];
                std::error_code gone;
                if (i % 2 == 0) fs::remove(file(), gone);
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (const int count : right) EXPECT_EQ(count, 10);
    for (const std::string& name : folder_.listing())
        EXPECT_TRUE(name == "stripes" || name.ends_with(".stripes")) << name; // nothing half written
}

} // namespace
} // namespace hachure::assets
