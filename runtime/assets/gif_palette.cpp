#include <hachure/runtime/assets/gif_palette.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::assets {
namespace {

constexpr PackedColor no_color = 0xffffffffu;
constexpr std::size_t coarse_cells = std::size_t{1} << 18; // 6 bits a channel
constexpr std::size_t exact_places = 1024;                 // four times what is ever in it
constexpr int lloyd_rounds = 4;

constexpr std::uint32_t channel(PackedColor color, int c) { return (color >> (16 - 8 * c)) & 0xffu; }

double square_distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    const double r = a[0] - b[0], g = a[1] - b[1], blue = a[2] - b[2];
    return r * r + g * g + blue * blue;
}

std::size_t nearest(const std::array<double, 3>& color, std::span<const std::array<double, 3>> to) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < to.size(); ++i)
        if (const double distance = square_distance(color, to[i]); distance < least) least = distance, best = i;
    return best;
}

PackedColor pack(const std::array<double, 3>& color) {
    PackedColor packed = 0;
    for (const double value : color)
        packed = packed << 8 | static_cast<PackedColor>(std::clamp(std::lround(value), 0l, 255l));
    return packed;
}

/// Sums over cells, of which the squared error about their mean follows.
struct Moments {
    double count = 0, squares = 0;
    std::array<double, 3> sum{};

    void add(double weight, const std::array<double, 3>& mean) {
        count += weight;
        for (std::size_t c = 0; c < 3; ++c) {
            sum[c] += weight * mean[c];
            squares += weight * mean[c] * mean[c];
        }
    }
    Moments operator-(const Moments& other) const {
        Moments result{count - other.count, squares - other.squares, sum};
        for (std::size_t c = 0; c < 3; ++c) result.sum[c] -= other.sum[c];
        return result;
    }
    double error() const {
        if (count <= 0) return 0;
        return std::max(0.0, squares - (sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / count);
    }
};

} // namespace

std::uint32_t ColorReduction::coarse_cell(PackedColor color) {
    return (channel(color, 0) >> 2) << 12 | (channel(color, 1) >> 2) << 6 | channel(color, 2) >> 2;
}

/// Where the colour is in the hash table, or would be put.
std::uint32_t ColorReduction::exact_cell(PackedColor color) const {
    std::uint32_t place = (color * 2654435761u) >> 22;
    while (exact_colors_[place] != color && exact_colors_[place] != no_color) place = (place + 1) % exact_places;
    return place;
}

void ColorReduction::choose(std::span<const PackedColor> pixels) {
    colors_.clear();
    exact_ = choose_exactly(pixels);
    if (exact_) return;
    colors_.clear();
    gather(pixels);
    cut();
    settle();
}

bool ColorReduction::choose_exactly(std::span<const PackedColor> pixels) {
    exact_colors_.assign(exact_places, no_color);
    index_of_cell_.resize(coarse_cells);
    PackedColor last = no_color;
    for (const PackedColor color : pixels) {
        if (color == last) continue;
        last = color;
        const std::uint32_t place = exact_cell(color);
        if (exact_colors_[place] == color) continue;
        if (colors_.size() == max_colors) return false;
        exact_colors_[place] = color;
        index_of_cell_[place] = static_cast<std::uint8_t>(colors_.size());
        colors_.push_back(color);
    }
    return true;
}

void ColorReduction::gather(std::span<const PackedColor> pixels) {
    sums_.assign(coarse_cells, {});
    for (const PackedColor color : pixels) {
        std::array<std::uint32_t, 4>& sum = sums_[coarse_cell(color)];
        sum[0] += 1;
        for (int c = 0; c < 3; ++c)
            sum[static_cast<std::size_t>(c) + 1] += channel(color, c) & 3u; // the rest is the cell's
    }
    cells_.clear();
    for (std::uint32_t place = 0; place < coarse_cells; ++place) {
        const std::array<std::uint32_t, 4>& sum = sums_[place];
        if (sum[0] == 0) continue;
        Cell cell{place, static_cast<double>(sum[0]), {}};
        for (std::size_t c = 0; c < 3; ++c)
            cell.mean[c] = static_cast<double>((place >> (12 - 6 * c) & 63u) * 4) + sum[c + 1] / cell.count;
        cells_.push_back(cell);
    }
}

/// Where the box is best cut in two, along any of the three axes.
void ColorReduction::find_cut(Box& box) {
    const std::span<Cell> cells(cells_.data() + box.begin, box.end - box.begin);
    Moments all;
    for (const Cell& cell : cells) all.add(cell.count, cell.mean);
    box.gain = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        std::ranges::sort(cells, [a](const Cell& x, const Cell& y) {
            return x.mean[a] != y.mean[a] ? x.mean[a] < y.mean[a] : x.place < y.place;
        });
        Moments below;
        for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
            below.add(cells[i].count, cells[i].mean);
            const double gain = all.error() - below.error() - (all - below).error();
            if (gain > box.gain) box.gain = gain, box.axis = axis, box.middle = box.begin + i + 1;
        }
    }
}

void ColorReduction::cut() {
    boxes_.assign(1, {0, cells_.size()});
    find_cut(boxes_[0]);
    while (boxes_.size() < max_colors) {
        Box& box = *std::ranges::max_element(boxes_, {}, &Box::gain);
        if (box.gain <= 0) break;
        const auto a = static_cast<std::size_t>(box.axis);
        std::sort(cells_.begin() + static_cast<std::ptrdiff_t>(box.begin),
                  cells_.begin() + static_cast<std::ptrdiff_t>(box.end), [a](const Cell& x, const Cell& y) {
                      return x.mean[a] != y.mean[a] ? x.mean[a] < y.mean[a] : x.place < y.place;
                  });
        Box upper{box.middle, box.end};
        box.end = box.middle;
        find_cut(box);
        find_cut(upper);
        boxes_.push_back(upper);
    }
    means_.clear();
    for (const Box& box : boxes_) {
        Moments all;
        for (std::size_t i = box.begin; i < box.end; ++i) all.add(cells_[i].count, cells_[i].mean);
        means_.push_back({all.sum[0] / all.count, all.sum[1] / all.count, all.sum[2] / all.count});
    }
}

/// Moves the colours to the means of the cells nearest to them, a few times, and keeps who chose what.
void ColorReduction::settle() {
    for (int round = 0; round < lloyd_rounds; ++round) {
        std::array<Moments, max_colors> chosen{};
        for (const Cell& cell : cells_) chosen[nearest(cell.mean, means_)].add(cell.count, cell.mean);
        for (std::size_t i = 0; i < means_.size(); ++i)
            if (chosen[i].count > 0)
                for (std::size_t c = 0; c < 3; ++c) means_[i][c] = chosen[i].sum[c] / chosen[i].count;
    }
    for (const Cell& cell : cells_) index_of_cell_[cell.place] = static_cast<std::uint8_t>(nearest(cell.mean, means_));
    for (const std::array<double, 3>& mean : means_) colors_.push_back(pack(mean));
}

} // namespace hachure::assets
