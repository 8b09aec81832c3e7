#include <hachure/runtime/geometry/surface_walk.h>
#include <hachure/systems/shade_strokes/shade_cells.h>
#include <hachure/systems/shade_strokes/slot_array.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

namespace hachure {
namespace {

using geometry::SurfaceSheets;

constexpr std::uint32_t most_parts = 128; // of a triangle's edges
constexpr double atom_length = 0.75;      // longest edge of an atom, over the side of a cell
constexpr double most_atoms = 8.0e6;      // beyond one per triangle
constexpr double feature_cosine = 0.77;   // 40 degrees
constexpr double least_part = 0.35;       // of a cell's area: a smaller first guess seeds no cell
constexpr double turn_cost = 4.0;         // of a normal's turn, over that of distance

/// An atom's number within its triangle, from the row and column of its parallelogram and which half of it.
std::uint32_t place_of(std::uint32_t n, std::uint32_t i, std::uint32_t j, bool upper) {
    return i * (2 * n - i) + 2 * j + (upper ? 1 : 0);
}

struct AtomPlace {
    std::uint32_t i, j;
    bool upper;
};

AtomPlace parts_of(std::uint32_t n, std::uint32_t place) {
    // Row i begins at i (2n - i), of which i is the smaller root.
    auto i = static_cast<std::uint32_t>(n - std::sqrt(std::max(0.0, double(n) * n - place)));
    while (i > 0 && i * (2 * n - i) > place) --i;
    while (i + 1 < n && (i + 1) * (2 * n - i - 1) <= place) ++i;
    const std::uint32_t rest = place - i * (2 * n - i);
    return {i, rest / 2, rest % 2 == 1};
}

/// How finely to divide triangles so that no atom is much longer than a cell.
void divide(const SurfaceSheets& sheets, double side, ShadeCells& cells) {
    std::vector<double> wanted(sheets.triangles.size(), 1.0);
    double total = 0.0;
    for (std::size_t t = 0; t < wanted.size(); ++t) {
        double longest = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3& a = sheets.positions[sheets.triangles[t][k]];
            longest = std::max(longest, glm::distance(a, sheets.positions[sheets.triangles[t][(k + 1) % 3]]));
        }
        if (side > 0.0) wanted[t] = std::clamp(std::ceil(longest / (atom_length * side)), 1.0, double(most_parts));
        total += wanted[t] * wanted[t] - 1.0;
    }
    const double scale = total > most_atoms ? std::sqrt(most_atoms / total) : 1.0;
    cells.first_atom.push_back(0);
    for (const double parts : wanted) {
        cells.parts.push_back(static_cast<std::uint16_t>(std::max(1.0, std::floor(parts * scale))));
        const std::uint32_t n = cells.parts.back();
        cells.first_atom.push_back(cells.first_atom.back() + n * n);
    }
}

/// Where an atom lies and which ones are beside it.
struct Atoms {
    const SurfaceSheets& sheets;
    const ShadeCells& cells;
    std::vector<std::uint32_t> triangle; ///< per atom
    std::vector<glm::vec3> centre;       ///< per atom
    std::vector<glm::vec3> normal;       ///< per triangle; 0 without an area

    Atoms(const SurfaceSheets& s, const ShadeCells& c) : sheets(s), cells(c) {
        triangle.resize(c.first_atom.back());
        centre.resize(triangle.size());
        for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
            const geometry::WalkTriangle shape(s, t);
            normal.emplace_back(shape.normal);
            for (std::uint32_t a = c.first_atom[t]; a < c.first_atom[t + 1]; ++a) {
                const auto corners = c.atom_corners(t, a);
                triangle[a] = t;
                centre[a] = shape.at((corners[0] + corners[1] + corners[2]) / 3.0);
            }
        }
    }

    /// The atom beyond the middle of side k of an atom, or `no_slot`.
    [[nodiscard]] std::uint32_t beside(std::uint32_t atom, std::size_t k) const {
        const std::uint32_t t = triangle[atom], n = cells.parts[t];
        const AtomPlace p = parts_of(n, atom - cells.first_atom[t]);
        const std::uint32_t first = cells.first_atom[t];
        if (p.upper) { // its neighbours are lower ones of the same triangle
            if (k == 0) return first + place_of(n, p.i, p.j, false);
            return first + (k == 1 ? place_of(n, p.i + 1, p.j, false) : place_of(n, p.i, p.j + 1, false));
        }
        if (k == 0 && p.i + p.j + 1 < n) return first + place_of(n, p.i, p.j, true);
        if (k == 1 && p.i > 0) return first + place_of(n, p.i - 1, p.j, true);
        if (k == 2 && p.j > 0) return first + place_of(n, p.i, p.j - 1, true);
        // Side k lies on the triangle's edge across from corner k.
        const auto edge = static_cast<std::uint32_t>((k + 1) % 3);
        const std::uint32_t back = sheets.opposite[3 * t + edge];
        if (back == SurfaceSheets::none) return no_slot;
        const auto corners = cells.atom_corners(t, atom);
        const glm::dvec3 middle = 0.5 * (corners[(k + 1) % 3] + corners[(k + 2) % 3]);
        glm::dvec3 weight(0.0);
        weight[back % 3] = middle[(edge + 1) % 3];
        weight[(back + 1) % 3] = middle[edge];
        return cells.atom_at(back / 3, weight);
    }
};

/// Growth of cells from seeds, the nearest first.
class Growth {
public:
    explicit Growth(const Atoms& atoms) : atoms_(atoms), cell_(atoms.triangle.size(), no_slot) {}

    /// Grows one cell until it has an area; returns that.
    double grow_one(std::uint32_t seed, double enough, std::span<const double> areas) {
        double area = 0.0;
        queue_ = {};
        const auto cell = static_cast<std::uint32_t>(seeds_.size());
        seeds_.push_back(seed);
        offer(seed, cell);
        while (!queue_.empty() && (area < enough || cell_[seed] == no_slot)) {
            const std::uint32_t atom = std::get<1>(queue_.top());
            queue_.pop();
            if (cell_[atom] != no_slot) continue;
            cell_[atom] = cell;
            area += area_of(atom, areas);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t next = atoms_.beside(atom, k);
                if (next != no_slot && cell_[next] == no_slot && turn(seed, next) > feature_cosine) offer(next, cell);
            }
        }
        return area;
    }

    /// Grows a cell from every seed at once, until all that they reach is taken.
    void grow_all(std::vector<std::uint32_t> seeds) {
        seeds_ = std::move(seeds);
        std::ranges::fill(cell_, no_slot);
        queue_ = {};
        for (std::uint32_t c = 0; c < seeds_.size(); ++c) offer(seeds_[c], c);
        while (!queue_.empty()) {
            const auto [cost, atom, cell] = queue_.top();
            queue_.pop();
            if (cell_[atom] != no_slot) continue;
            cell_[atom] = cell;
            for (std::size_t k = 0; k < 3; ++k)
                if (const std::uint32_t next = atoms_.beside(atom, k); next != no_slot && cell_[next] == no_slot)
                    offer(next, cell);
        }
    }

    [[nodiscard]] std::vector<std::uint32_t>& cells() { return cell_; }
    [[nodiscard]] std::size_t count() const { return seeds_.size(); }
    [[nodiscard]] double area_of(std::uint32_t atom, std::span<const double> areas) const {
        const std::uint32_t t = atoms_.triangle[atom], n = atoms_.cells.parts[t];
        return areas[t] / (double(n) * n);
    }

private:
    using Offer = std::tuple<float, std::uint32_t, std::uint32_t>; ///< cost, atom, cell

    [[nodiscard]] float turn(std::uint32_t seed, std::uint32_t atom) const {
        const glm::vec3 &a = atoms_.normal[atoms_.triangle[seed]], &b = atoms_.normal[atoms_.triangle[atom]];
        return a == glm::vec3(0.0f) || b == glm::vec3(0.0f) ? 1.0f : glm::dot(a, b);
    }
    void offer(std::uint32_t atom, std::uint32_t cell) {
        const std::uint32_t seed = seeds_[cell];
        const float away = glm::distance(atoms_.centre[seed], atoms_.centre[atom]);
        queue_.emplace(away * (1.0f + static_cast<float>(turn_cost) * (1.0f - turn(seed, atom))), atom, cell);
    }

    const Atoms& atoms_;
    std::vector<std::uint32_t> cell_; ///< per atom
    std::vector<std::uint32_t> seeds_;
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> queue_;
};

/// The atom nearest to the middle of each cell of a first guess that is large enough to be one.
std::vector<std::uint32_t> better_seeds(const Atoms& atoms, const Growth& growth,
                                        const std::vector<std::uint32_t>& cell, const std::vector<double>& area,
                                        double least, std::span<const double> areas) {
    std::vector<glm::dvec3> sum(area.size(), glm::dvec3(0.0));
    std::vector<std::pair<double, std::uint32_t>> nearest(area.size(), {1e300, no_slot});
    for (std::uint32_t a = 0; a < cell.size(); ++a)
        sum[cell[a]] += growth.area_of(a, areas) * glm::dvec3(atoms.centre[a]);
    for (std::uint32_t a = 0; a < cell.size(); ++a) {
        const double own = area[cell[a]];
        if (!(own > least)) continue;
        const double away = glm::distance(sum[cell[a]] / own, glm::dvec3(atoms.centre[a]));
        nearest[cell[a]] = std::min(nearest[cell[a]], {away, a});
    }
    std::vector<std::uint32_t> seeds;
    for (const auto& [away, atom] : nearest)
        if (atom != no_slot) seeds.push_back(atom);
    return seeds;
}

/// Lists the members of cells and their areas.
void list_members(const Growth& growth, std::span<const double> areas, std::size_t count, ShadeCells& cells) {
    cells.area.assign(count, 0.0f);
    cells.first_member.assign(count + 1, 0);
    for (const std::uint32_t c : cells.cell_of_atom) ++cells.first_member[c + 1];
    std::partial_sum(cells.first_member.begin(), cells.first_member.end(), cells.first_member.begin());
    std::vector<std::uint32_t> next(cells.first_member.begin(), cells.first_member.end() - 1);
    std::vector<double> sum(count, 0.0);
    cells.members.resize(cells.cell_of_atom.size());
    cells.share.resize(cells.members.size());
    for (std::uint32_t a = 0; a < cells.cell_of_atom.size(); ++a) {
        const std::uint32_t c = cells.cell_of_atom[a];
        sum[c] += growth.area_of(a, areas);
        cells.members[next[c]] = a;
        cells.share[next[c]++] = static_cast<float>(sum[c]);
    }
    for (std::size_t c = 0; c < count; ++c) cells.area[c] = static_cast<float>(sum[c]);
}

} // namespace

std::uint32_t ShadeCells::atom_at(std::uint32_t triangle, const glm::dvec3& weight) const {
    const std::uint32_t n = parts[triangle];
    if (n == 1) return first_atom[triangle];
    const double x = std::clamp(weight[1], 0.0, 1.0) * n, y = std::clamp(weight[2], 0.0, 1.0) * n;
    const std::uint32_t i = std::min(static_cast<std::uint32_t>(x), n - 1);
    const std::uint32_t j = std::min(static_cast<std::uint32_t>(y), n - 1 - i);
    const bool upper = (x - i) + (y - j) > 1.0 && i + j + 1 < n;
    return first_atom[triangle] + place_of(n, i, j, upper);
}

std::uint32_t ShadeCells::triangle_of(std::uint32_t atom) const {
    return static_cast<std::uint32_t>(std::ranges::upper_bound(first_atom, atom) - first_atom.begin()) - 1;
}

std::array<glm::dvec3, 3> ShadeCells::atom_corners(std::uint32_t triangle, std::uint32_t atom) const {
    const std::uint32_t n = parts[triangle];
    const AtomPlace p = parts_of(n, atom - first_atom[triangle]);
    const auto corner = [&](std::uint32_t i, std::uint32_t j) {
        const double u = double(i) / n, v = double(j) / n;
        return glm::dvec3(1.0 - u - v, u, v);
    };
    if (p.upper) return {corner(p.i + 1, p.j + 1), corner(p.i, p.j + 1), corner(p.i + 1, p.j)};
    return {corner(p.i, p.j), corner(p.i + 1, p.j), corner(p.i, p.j + 1)};
}

ShadeCells::Point ShadeCells::point_in(std::uint32_t cell, double which, double a, double b) const {
    const auto begin = share.begin() + first_member[cell], end = share.begin() + first_member[cell + 1];
    auto found = std::upper_bound(begin, end, static_cast<float>(which) * area[cell]);
    if (found == end) --found;
    const std::uint32_t atom = members[static_cast<std::size_t>(found - share.begin())], triangle = triangle_of(atom);
    const auto corners = atom_corners(triangle, atom);
    if (a + b > 1.0) {
        a = 1.0 - a;
        b = 1.0 - b;
    }
    return {triangle, corners[0] + a * (corners[1] - corners[0]) + b * (corners[2] - corners[0])};
}

ShadeCells make_shade_cells(const SurfaceSheets& sheets, std::span<const double> areas, std::uint32_t wanted) {
    ShadeCells cells;
    const double total = std::accumulate(areas.begin(), areas.end(), 0.0), size = total / std::max(1u, wanted);
    divide(sheets, std::sqrt(size), cells);
    const Atoms atoms(sheets, cells);
    Growth growth(atoms);
    std::vector<double> guessed;
    for (std::uint32_t a = 0; a < atoms.triangle.size(); ++a)
        if (growth.cells()[a] == no_slot) guessed.push_back(growth.grow_one(a, size, areas));
    const std::vector<std::uint32_t> guess = growth.cells();
    growth.grow_all(better_seeds(atoms, growth, guess, guessed, least_part * size, areas));
    // What no seed reaches, as pieces smaller than a cell, are cells of their own.
    std::size_t count = growth.count();
    std::vector<std::uint32_t> own(guessed.size(), no_slot);
    for (std::uint32_t a = 0; a < guess.size(); ++a) {
        if (growth.cells()[a] != no_slot) continue;
        std::uint32_t& cell = own[guess[a]];
        if (cell == no_slot) cell = static_cast<std::uint32_t>(count++);
        growth.cells()[a] = cell;
    }
    cells.cell_of_atom = growth.cells();
    list_members(growth, areas, count, cells);
    return cells;
}

} // namespace hachure
