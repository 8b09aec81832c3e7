// Snapshots of a large world over their floor: writing and reading a file of as many bytes. Entities carry two
// components of six numbers and more, nearly all of which differ from their defaults.

#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/ecs/snapshot.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/support/temp_folder.h>

#include <cstdlib>
#include <vector>

namespace hachure::bench {

struct Body {
    glm::vec3 velocity{0};
    float mass = 1;
    float radius = 1;
    float charge = 0;
    float spin = 0;
};

void reflect(TypeBuilder<Body>& type) {
    type.name("body");
    type.field("velocity", &Body::velocity);
    type.field("mass", &Body::mass).range(0, 1e9);
    type.field("radius", &Body::radius);
    type.field("charge", &Body::charge);
    type.field("spin", &Body::spin);
}

struct Place {
    glm::vec3 translation{0};
    glm::quat rotation{1, 0, 0, 0};
    bool fixed = false;
};

void reflect(TypeBuilder<Place>& type) {
    type.name("place");
    type.field("translation", &Place::translation);
    type.field("rotation", &Place::rotation);
    type.field("fixed", &Place::fixed);
}

namespace {

constexpr double limit_over_floor = 10;

void fill(World& world, std::size_t count) {
    world.create_each<Body, Place>(count, [](std::size_t i, Entity, Body& body, Place& place) {
        const float x = static_cast<float>(i) + 0.5f;
        body = {glm::vec3(x), x, x, x, x};
        place = {glm::vec3(x), glm::quat(0.8f, 0, 0.6f, 0), i % 2 == 0};
    });
}

/// The median of so many runs, in milliseconds.
template <class F> double time(int runs, F&& f) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        const double begin = now_ms();
        f();
        times.push_back(now_ms() - begin);
    }
    return median(times);
}

} // namespace
} // namespace hachure::bench

int main(int argc, char** argv) {
    using namespace hachure;
    const auto arguments = bench::parse_arguments(argc, argv, "saving and restoring worlds");
    const int runs = arguments.quick ? 1 : 5;
    TypeRegistry types;
    types.add<bench::Body>();
    types.add<bench::Place>();
    World world;
    bench::fill(world, arguments.quick ? 1000 : 1'000'000);

    std::vector<std::byte> snapshot;
    const double save = bench::time(runs, [&] { snapshot = save_snapshot(world, types); });
    const double restore = bench::time(runs, [&] {
        World other;
        restore_snapshot(other, types, snapshot);
        if (other.size() != world.size()) std::abort();
    });
    const test::TempFolder folder;
    const double write = bench::time(runs, [&] { assets::write_file_atomically(folder / "raw", snapshot); });
    const double read = bench::time(runs, [&] { static_cast<void>(assets::read_file_bytes(folder / "raw")); });

    bench::Report report(arguments);
    report.add("entities", static_cast<double>(world.size()), "");
    report.add("size", static_cast<double>(snapshot.size()) / 1e6, "MB");
    report.add("save", save, "ms");
    report.add("restore", restore, "ms");
    report.add("write the bytes", write, "ms");
    report.add("read the bytes", read, "ms");
    report.add_limited("save over write", save / write, "x", bench::limit_over_floor);
    report.add_limited("restore over read", restore / read, "x", bench::limit_over_floor);
    return report.finish();
}
