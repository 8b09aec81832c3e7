#include <hachure/runtime/parallel.h>
#include <hachure/systems/paper/grain.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure {
namespace {

constexpr std::size_t side = grain_tile;
constexpr float finest_period = 4.0f; // px, of ribs and threads
constexpr float tau = glm::two_pi<float>();

using Tile = std::vector<float>;

/// One row of the tile at a time, each on any thread.
template <class Value> Tile make_tile(const Value& value) {
    Tile tile(side * side);
    parallel_for(side, [&](std::size_t y) {
        for (std::size_t x = 0; x < side; ++x) tile[y * side + x] = value(x, y);
    });
    return tile;
}

/// Bits of number `index` in the row that `key` names (a 32-bit finaliser with little bias, Wellons 2018).
std::uint32_t random_bits(std::uint32_t key, std::uint32_t index) {
    std::uint32_t x = index + key * 0x9e3779b9u;
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

/// Evenly distributed, of mean 0 and variance 1, each texel for itself.
Tile white_noise(std::uint32_t key) {
    return make_tile([key](std::size_t x, std::size_t y) {
        const std::uint32_t bits = random_bits(key, static_cast<std::uint32_t>(y * side + x));
        return (static_cast<float>(bits >> 8) / 16777216.0f - 0.5f) * std::sqrt(12.0f);
    });
}

std::vector<float> gaussian(float deviation) {
    deviation = std::min(deviation, 0.125f * side); // wider ones would meet themselves
    const int reach = std::max(1, static_cast<int>(std::ceil(3.5f * deviation)));
    std::vector<float> weights;
    float sum = 0.0f;
    for (int i = -reach; i <= reach; ++i) {
        weights.push_back(std::exp(-0.5f * static_cast<float>(i * i) / (deviation * deviation)));
        sum += weights.back();
    }
    for (float& weight : weights) weight /= sum;
    return weights;
}

/// Along rows, round the edge of the tile; the result is transposed, so that twice does both directions. Some rows at a
/// time: what is next to each other in the result is written together.
Tile blurred_rows(const Tile& tile, const std::vector<float>& weights) {
    constexpr std::size_t group = 16;
    const std::size_t reach = weights.size() / 2;
    Tile result(tile.size());
    parallel_for(side / group, [&](std::size_t part) {
        std::vector<float> row(side + 2 * reach), sums(group * side, 0.0f);
        for (std::size_t g = 0; g < group; ++g) {
            const float* from = &tile[(part * group + g) * side];
            for (std::size_t i = 0; i < row.size(); ++i) row[i] = from[(i + side - reach) % side];
            for (std::size_t k = 0; k < weights.size(); ++k)
                for (std::size_t x = 0; x < side; ++x) sums[g * side + x] += weights[k] * row[x + k];
        }
        for (std::size_t x = 0; x < side; ++x)
            for (std::size_t g = 0; g < group; ++g) result[x * side + part * group + g] = sums[g * side + x];
    });
    return result;
}

Tile blurred(const Tile& tile, float across, float down) {
    return blurred_rows(blurred_rows(tile, gaussian(across)), gaussian(down));
}

void scale_to_unit(Tile& tile) {
    double sum = 0.0, squares = 0.0;
    for (const float value : tile) sum += value, squares += static_cast<double>(value) * value;
    const double mean = sum / static_cast<double>(tile.size());
    const double deviation = std::sqrt(std::max(squares / static_cast<double>(tile.size()) - mean * mean, 1e-30));
    for (float& value : tile) value = static_cast<float>((value - mean) / deviation);
}

/// Noise of one size of grain, variance 1: two blurs apart, which leaves neither single pixels nor clouds. Most of it
/// repeats after 6.5 deviations.
Tile band(std::uint32_t key, float deviation) {
    deviation = std::max(deviation, 0.65f); // finer, and pixels would not hold it
    const Tile noise = white_noise(key);
    Tile fine = blurred(noise, deviation, deviation);
    const Tile coarse = blurred(noise, 2.0f * deviation, 2.0f * deviation);
    for (std::size_t i = 0; i < fine.size(); ++i) fine[i] -= coarse[i];
    scale_to_unit(fine);
    return fine;
}

/// Noise that is drawn out, variance 1.
Tile fibres(std::uint32_t key, float across, float down) {
    Tile tile = blurred(white_noise(key), across, down);
    scale_to_unit(tile);
    return tile;
}

/// How often something of that period comes in a tile that has to close: a multiple of `step`.
float count_of(float period, int step) {
    return static_cast<float>(std::max(1, static_cast<int>(std::lround(side / period / static_cast<float>(step)))) *
                              step);
}

Tile tooth(float scale, std::uint32_t seed) {
    Tile fine = band(4 * seed, 0.75f * scale);
    const Tile coarse = band(4 * seed + 1, 1.6f * scale);
    for (std::size_t i = 0; i < fine.size(); ++i) fine[i] += 0.45f * coarse[i];
    return fine;
}

/// Bumps with single pits between them, where two noises are zero at once.
Tile cold_press(float scale, std::uint32_t seed) {
    const Tile one = band(4 * seed, 2.2f * scale), other = band(4 * seed + 1, 2.2f * scale),
               fine = band(4 * seed + 2, 0.8f * scale);
    return make_tile([&](std::size_t x, std::size_t y) {
        const std::size_t i = y * side + x;
        return std::hypot(one[i], other[i]) + 0.25f * fine[i];
    });
}

/// Ribs lie across, as in a sheet held upright; their height and place wander a little, as wires do.
Tile laid(float scale, std::uint32_t seed) {
    const float ribs = count_of(std::max(5.5f * scale, finest_period), 1), chains = count_of(110.0f * scale, 1);
    const Tile drift = fibres(4 * seed, 40.0f * scale, 6.0f * scale), grain = band(4 * seed + 1, 0.8f * scale),
               streaks = fibres(4 * seed + 2, 8.0f * scale, 0.8f * scale);
    return make_tile([&](std::size_t x, std::size_t y) {
        const std::size_t i = y * side + x;
        const float rib = std::sin(tau * ribs * static_cast<float>(y) / grain_tile + 0.25f * drift[i]);
        const float from_chain = 0.5f - std::abs(std::fmod(chains * static_cast<float>(x) / grain_tile, 1.0f) - 0.5f);
        const float chain = std::exp(-0.5f * std::pow(from_chain * side / chains / (1.6f * scale), 2.0f));
        return rib - 0.7f * chain + 0.7f * grain[i] + 0.25f * streaks[i];
    });
}

/// Height of a thread at `across` (its middle at one half) that dives under the others once per two of them.
float thread(float across, float along) {
    const float from_middle = 2.0f * (across - std::floor(across)) - 1.0f;
    const float side_of = std::fmod(std::floor(across), 2.0f) < 1.0f ? 1.0f : -1.0f;
    const float round = std::sqrt(std::max(0.0f, 1.0f - from_middle * from_middle));
    return round * (0.62f + 0.38f * side_of * std::sin(0.5f * tau * along));
}

Tile canvas(float scale, std::uint32_t seed) {
    const float threads = count_of(std::max(7.0f * scale, finest_period), 2);
    const Tile warp = fibres(4 * seed, 2.0f * scale, 24.0f * scale),
               weft = fibres(4 * seed + 1, 24.0f * scale, 2.0f * scale), grain = band(4 * seed + 2, 0.8f * scale);
    const Tile weave = make_tile([&](std::size_t x, std::size_t y) {
        const std::size_t i = y * side + x;
        const float u = threads * static_cast<float>(x) / grain_tile + 0.06f * weft[i];
        const float v = threads * static_cast<float>(y) / grain_tile + 0.06f * warp[i];
        const float over = thread(u + 2.0f, v) + 0.05f * warp[i], under = thread(v + 2.0f, u + 1.0f) + 0.05f * weft[i];
        return std::max(over, under) + 0.08f * grain[i];
    });
    return blurred(weave, 0.6f, 0.6f);
}

} // namespace

std::vector<float> paper_grain(PaperKind kind, float scale, std::uint32_t seed) {
    switch (kind) {
    case PaperKind::cold_press:
        return cold_press(scale, seed);
    case PaperKind::laid:
        return laid(scale, seed);
    case PaperKind::canvas:
        return canvas(scale, seed);
    case PaperKind::tooth:
        break;
    }
    return tooth(scale, seed);
}

} // namespace hachure
