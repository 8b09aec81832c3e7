#pragma once

#include <hachure/systems/shade_strokes/chain_editor.h>
#include <hachure/systems/shade_strokes/shade_chains.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>
#include <hachure/systems/shade_strokes/shade_settings.h>
#include <hachure/systems/shade_strokes/stroke_narrowing.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

class ChainWalk;

/// What an update did.
struct ShadeUpdateStats {
    std::uint32_t swept = 0;    ///< cells whose need was compared with what they hold
    std::uint32_t touched = 0;  ///< cells that were strengthened or weakened
    std::uint32_t steps = 0;    ///< triangles and parts of them that chains were walked over
    std::uint32_t begun = 0;    ///< chains
    std::uint32_t extended = 0; ///< ends of chains that went on
    std::uint32_t joined = 0;   ///< pairs of chains
    std::uint32_t removed = 0;  ///< segments
    std::uint32_t unmet = 0;    ///< cells that need more than strokes there can give
};

/// Brings the strokes of a surface from what they were to what the light needs now (section 2.3.3.3, as readings.md
/// reads it). Needed shade is compared with delivered shade, so that slow changes add up until they are noticed; what
/// differs by no more than the dead band stays, but where nothing is needed nothing stays. Where more is needed,
/// strokes get stronger, then chains that wait at the cell go on into it, then new ones are begun; where less, they get
/// weaker, ends of chains first, and those that fade out go, which may split a chain. Ends that meet are joined.
/// Strokes that are drawn narrower than they were laid deliver as much less.
///
/// The result is a function of mesh, settings and the sequence of needs and narrowings since the chains were empty, bit
/// for bit. The cost is that of the cells touched, besides one comparison per cell.
struct ShadeUpdateJob {
    const ShadeMesh* mesh = nullptr;
    ShadeSettings settings{};        ///< with other ones than in the run before, all strokes are drawn anew
    std::span<const float> needed{}; ///< per cell, in [0, 1], as of ShadeLightJob
    bool changed = true;             ///< whether `needed` may be another one than in the run before
    StrokeNarrowing narrowing{};     ///< how narrow strokes are drawn
    bool narrowed = false;           ///< whether that may be another one than in the run before
    ShadeChains* chains = nullptr;   ///< in and out

    ShadeUpdateStats stats{}; ///< out

    /// Asserts that sizes agree and settings are in range.
    void validate() const;
    void run();

    /// The cells that the last run strengthened or weakened.
    [[nodiscard]] std::span<const std::uint32_t> touched() const { return touched_; }

    /// Forgets all strokes; the next run begins from nothing.
    void reset();

    /// Kept from run to run.
    const ShadeMesh* last_mesh = nullptr;
    ShadeSettings last_settings{};
    std::vector<std::uint32_t> open{}; ///< scratch: segments of a cell, or cells

private:
    void start_over();
    void narrow(ChainEditor& editor, std::uint32_t cell);
    [[nodiscard]] bool differs(std::uint32_t cell) const;
    void weaken(ChainEditor& editor, std::uint32_t cell);
    [[nodiscard]] double list_fading(std::uint32_t cell);
    void remove(ChainEditor& editor, std::uint32_t segment);
    void strengthen(ChainEditor& editor, std::uint32_t cell, double least);
    void extend(ChainWalk& walk, std::uint32_t cell);
    void begin_chains(ChainWalk& walk, std::uint32_t cell);
    [[nodiscard]] ShadeCells::Point start_point(std::uint32_t cell, std::uint64_t random) const;
    void note_unmet(std::uint32_t cell);
    [[nodiscard]] float missing(std::uint32_t cell) const { return needed[cell] - chains->cells[cell].delivered; }

    std::vector<std::uint32_t> touched_{};
    std::vector<double> fading_; ///< scratch: of `open`, alpha that each loses
};

} // namespace hachure
