#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::assets {

/// A colour of 8 bits a channel: 0xRRGGBB.
using PackedColor = std::uint32_t;

/// Chooses few colours for many and says which of them each pixel gets. Colours are gathered in cells of 4 x 4 x 4
/// values; the cells are cut where that lowers the squared error most (Wu, "Efficient statistical computations for
/// optimal color quantization", 1991), then the colours are moved to the means of what chose them (Lloyd's iteration).
/// Nothing is dithered: noise that changes from frame to frame is worse than a step of a tone. Buffers are kept, so
/// that later calls of the same size allocate nothing.
class ColorReduction {
public:
    static constexpr std::size_t max_colors = 255;

    /// Chooses at most max_colors for `pixels`; exactly theirs when there are no more.
    void choose(std::span<const PackedColor> pixels);

    /// Those of the last choice, at least one unless there were no pixels.
    [[nodiscard]] std::span<const PackedColor> colors() const { return colors_; }

    /// Which of `colors()` stands for `color`, one of the pixels of the last choice.
    [[nodiscard]] std::uint8_t index_of(PackedColor color) const { return index_of_cell_[cell_of(color)]; }

private:
    /// Pixels of like colours.
    struct Cell {
        std::uint32_t place = 0;      ///< in the tables
        double count = 0;             ///< pixels
        std::array<double, 3> mean{}; ///< their colour
    };
    /// Cells [begin, end) of cells_, which get one colour.
    struct Box {
        std::size_t begin = 0, end = 0;
        double gain = 0;        ///< squared error that the best cut takes away; 0: it can't be cut
        int axis = 0;           ///< of that cut
        std::size_t middle = 0; ///< cells below it go to the one side, once sorted along the axis
    };

    /// In a choice of exact colours, cells are single colours: these tables would be too large for all 2^24.
    [[nodiscard]] std::uint32_t cell_of(PackedColor color) const {
        return exact_ ? exact_cell(color) : coarse_cell(color);
    }
    [[nodiscard]] static std::uint32_t coarse_cell(PackedColor color);
    [[nodiscard]] std::uint32_t exact_cell(PackedColor color) const;

    bool choose_exactly(std::span<const PackedColor> pixels);
    void gather(std::span<const PackedColor> pixels);
    void find_cut(Box& box);
    void cut();
    void settle();

    bool exact_ = false;
    std::vector<PackedColor> colors_;
    std::vector<std::uint8_t> index_of_cell_;
    std::vector<PackedColor> exact_colors_;          // an open hash table, place by place; a colour or `no_color`
    std::vector<std::array<std::uint32_t, 4>> sums_; // by coarse cell: count, red, green, blue
    std::vector<Cell> cells_;
    std::vector<Box> boxes_;
    std::vector<std::array<double, 3>> means_;
};

} // namespace hachure::assets
