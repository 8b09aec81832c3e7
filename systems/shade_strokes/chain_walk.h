#pragma once

#include <hachure/runtime/geometry/surface_walk.h>
#include <hachure/systems/shade_strokes/chain_editor.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>
#include <hachure/systems/shade_strokes/shade_ribs.h>
#include <hachure/systems/shade_strokes/shade_settings.h>
#include <hachure/systems/shade_strokes/stroke_narrowing.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hachure {

/// Of a cell's shade that segments are taken for at least where they get alpha: what little the cell lacks would make
/// small ones jump.
inline constexpr double least_share = 0.25;

/// Walks chains over a surface (section 2.3.3.1): lays segments and brings the cells that it passes as much shade as
/// they need. A chain ends before a cell that needs no more, where the normal has turned too far from that where it was
/// begun, and where the sheet ends.
class ChainWalk {
public:
    ChainWalk(const ShadeMesh& mesh, const ShadeSettings& settings, const StrokeNarrowing& narrowing,
              std::span<const float> needed, ShadeChains& chains)
        : mesh_(mesh), settings_(settings), narrowing_(narrowing), needed_(needed), chains_(chains), editor_(chains) {}

    /// Begins a chain at a place and walks both ways. False when not even one segment came of it.
    bool begin(const geometry::WalkPlace& place, std::uint64_t random);

    /// Takes up the walk of an end that waits for a cell. False when no segment came of it.
    bool extend(std::uint32_t chain, ChainSide side);

    /// Whether a cell takes another stroke.
    [[nodiscard]] bool wants(std::uint32_t cell) const;

    std::uint32_t steps = 0;  ///< triangles and parts of them that were walked over, so far
    std::uint32_t joined = 0; ///< chains that met another's end, so far

private:
    /// A place on the way since the last node.
    struct Passed {
        geometry::WalkPlace place;
        glm::dvec3 direction; ///< of the step from here
        double length;        ///< from the last node to here
    };

    /// Where a piece is divided.
    struct Division {
        double length; ///< from the last node
        ShadeNode node;
    };

    bool walk(std::uint32_t chain, ChainSide side, const geometry::WalkPlace& place, const glm::dvec3& heading,
              std::uint32_t tip);
    bool aim(const geometry::WalkTriangle& triangle);
    bool enter(std::uint32_t cell);
    bool advance(const geometry::WalkStep& step);
    void step_back();
    bool join_in(std::uint32_t cell);
    [[nodiscard]] Passed on_way(double length) const;
    [[nodiscard]] ShadeRib rib_at(const Passed& passed) const;
    /// Ends the piece that is under way at node `next`, or when that is `no_slot` at a new one.
    void finish_piece(std::uint32_t next);
    [[nodiscard]] std::optional<double> most_bent(double begin, double end) const;
    [[nodiscard]] std::optional<Division> division(std::uint32_t from, double begin, std::uint32_t to,
                                                   double end) const;
    void lay(std::uint32_t from, double begin, std::uint32_t to, double end, int depth);
    void shade_piece();
    [[nodiscard]] std::uint32_t meeting(std::uint32_t cell) const;

    const ShadeMesh& mesh_;
    const ShadeSettings& settings_;
    const StrokeNarrowing& narrowing_;
    std::span<const float> needed_;
    ShadeChains& chains_;
    ChainEditor editor_;

    // The walk under way.
    std::uint32_t chain_ = no_slot, tip_ = no_slot, cell_ = no_slot;
    ShadeChain own_{}; ///< the chain, as it was when the walk began
    ChainSide side_ = ChainSide::end;
    double sign_ = 1.0; ///< of the walk along the chain: 1 towards its end
    geometry::WalkPlace place_{};
    glm::dvec3 heading_{0.0};
    std::uint32_t entered_ = geometry::WalkStep::inside; ///< the edge that was come over to here
    Passed left_{};                                      ///< that edge, on the side before it
    double start_ = 0.0;                                 ///< where the walk began along the chain
    double length_ = 0.0, walked_ = 0.0;                 ///< since the last node, and since the walk began
    std::vector<Passed> passed_;                         ///< since the last node
    std::vector<std::uint32_t> fresh_;                   ///< segments of the piece that is being laid
};

} // namespace hachure
