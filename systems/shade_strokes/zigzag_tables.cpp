#include <hachure/systems/shade_strokes/shade_random.h>
#include <hachure/systems/shade_strokes/zigzag_tables.h>

#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace hachure {
namespace {

constexpr std::uint64_t zigzag_seed = 2005;

/// Random numbers one after the other.
class ZigzagRandom {
public:
    explicit ZigzagRandom(std::uint64_t set) : stream_(zigzag_seed + set) {}
    double next() { return shade_uniform(stream_, ShadePurpose::wander, count_++); }

private:
    std::uint64_t stream_, count_ = 0;
};

/// Steps that are random and add up to the number of points; sums of all before (exclusive, so that the first is 0).
void fill_along(ZigzagRandom& random, std::span<glm::vec2> points) {
    std::vector<double> step(points.size());
    for (double& s : step) s = random.next();
    const double unit = static_cast<double>(points.size()) / std::accumulate(step.begin(), step.end(), 0.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].x = static_cast<float>(sum * unit);
        sum += step[i];
    }
}

/// Every `stride`-th point from `first` on gets a random number of its own part of [-1, 1], parts in random order.
void fill_across(ZigzagRandom& random, std::span<glm::vec2> points, std::size_t first, std::size_t stride) {
    const std::size_t count = points.size() / stride;
    std::vector<std::size_t> part(count);
    std::iota(part.begin(), part.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i)
        std::swap(part[i - 1], part[static_cast<std::size_t>(random.next() * static_cast<double>(i))]);
    for (std::size_t i = 0; i < count; ++i) {
        const double place = (static_cast<double>(part[i]) + random.next()) / static_cast<double>(count);
        points[first + i * stride].y = static_cast<float>(2.0 * place - 1.0);
    }
}

} // namespace

ZigzagTables make_zigzag_tables() {
    ZigzagTables tables{};
    for (std::size_t set = 0; set < ZigzagTables::sets; ++set) {
        ZigzagRandom random(set);
        const std::span points(tables.point.data() + set * ZigzagTables::points, ZigzagTables::points);
        fill_along(random, points);
        // From the coarsest level on: each finer one adds the points halfway.
        fill_across(random, points, 0, ZigzagTables::points / 2);
        for (std::size_t stride = ZigzagTables::points / 2; stride > 1; stride /= 2)
            fill_across(random, points, stride / 2, stride);
    }
    return tables;
}

} // namespace hachure
