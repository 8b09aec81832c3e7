#pragma once

#include <hachure/runtime/geometry/chain_segments.h>
#include <hachure/runtime/geometry/polylines.h>
#include <hachure/runtime/geometry/trace_ridges.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Which lines are too little to be drawn.
struct LineLimits {
    float min_length = 0.0f; ///< pixels: shorter ones with a free end are left out
    bool spurs = true;       ///< else those about as long as the line that they begin at is wide are, too
    bool gaps = false;       ///< gaps stay where no pixel shows a line of the kind
};

/// Makes lines of the pieces that TraceRidgesJob found: links them, closes gaps, and leaves some out.
///
/// Lines that touch are made to meet in one point. Elsewhere there is no ridge of one direction where lines meet, and
/// each ends about half a width before the others. A free end goes on to another one that it faces, several that face
/// each other to the place where they would meet, and one that faces no end to the line ahead of it.
struct LinkRidgesJob {
    std::span<const RidgeNode> nodes;
    std::span<const SegmentEnds> segments; ///< between nodes
    float gap = 1.0f;                      ///< how far an end may look ahead, pixels,
    float gap_widths = 0.75f;              ///< plus so many widths of its line
    /// What is left out, by owner; nothing where there is none.
    std::span<const LineLimits> limits{};
    RidgeImage image{}; ///< what pixels show, where `limits` keep gaps
    float sign = 1.0f;  ///< of the lines' curvature

    /// Out, kept from run to run; sorted by nothing but where they were found. Lines are at least two points long.
    PolylineSet lines{};

    /// Asserts that segments are between nodes.
    void validate() const;
    void run();

    /// Scratch, kept from run to run.
    struct FreeEnd {
        std::uint32_t node;
        glm::vec2 ahead; ///< unit: where the line would go on
        float reach;     ///< pixels
        std::uint32_t cluster = 0;
        float nearest = std::numeric_limits<float>::max(); ///< distance to the nearest end that it faces
    };
    /// Where a node is on its chain.
    struct NodePlace {
        std::uint32_t chain;
        float arc; ///< pixels from the chain's beginning
    };
    struct Linked {
        std::vector<RidgeNode> nodes;
        std::vector<SegmentEnds> segments;
        std::vector<float> lengths;
        std::vector<ChainedSegment> order;
        std::vector<std::uint32_t> degree; ///< per node: how many segments end there
        ChainSegmentsJob chains;
    };
    /// The place nearest to several straight lines (least squares), by the sums of its normal equations.
    struct MeetingPlace {
        float xx = 0.0f, xy = 0.0f, yy = 0.0f;
        glm::vec2 right{0.0f}, sum{0.0f};
        float count = 0.0f;

        void add(glm::vec2 place, glm::vec2 direction);
        /// The mean of the places that were given where the lines are all but parallel.
        [[nodiscard]] glm::vec2 solve() const;
    };
    /// A line that ends at a crossing.
    struct Arm {
        std::uint32_t node; ///< the crossing
        glm::vec2 place, direction;
    };
    /// Of lines that end at a node.
    struct Spurs {
        std::uint32_t count = 0, longest = 0;
    };
    Linked linked{};
    std::vector<Spurs> spurs{}; ///< by node
    std::vector<FreeEnd> free_ends{};
    std::vector<NodePlace> places{};
    std::vector<Arm> arms{};
    std::vector<std::uint32_t> merged{};      ///< per node: the one that stands for it
    std::vector<std::uint32_t> end_of_node{}; ///< per node: which free end it is
    std::vector<std::uint32_t> cell_starts{}, cell_nodes{};

private:
    /// Whether a gap between two places of an owner's lines may be closed: where gaps stay, pixels must show it closed.
    [[nodiscard]] bool may_join(std::uint32_t owner, glm::vec2 a, glm::vec2 b) const;
    [[nodiscard]] bool may_join(std::uint32_t a, std::uint32_t b) const; ///< two nodes
    struct Grid {
        float cell = 1.0f;
        glm::vec2 origin{0.0f};
        int columns = 0, rows = 0;
    };

    void chain();
    [[nodiscard]] std::uint32_t chain_node(const Chain& chain, std::uint32_t index) const;
    [[nodiscard]] glm::vec2 direction_ahead(const Chain& chain, bool at_end) const;
    void find_free_ends();
    void place_nodes();
    [[nodiscard]] Grid sort_into_grid(float cell);
    template <class Visit> void each_near(const Grid& grid, glm::vec2 at, Visit&& visit) const;
    void merge_touching();
    template <class Visit> void each_facing(const Grid& grid, Visit&& visit) const;
    void cluster_ends(const Grid& grid);
    void join_cluster(std::span<const FreeEnd> ends);
    [[nodiscard]] std::uint32_t find_line_ahead(const Grid& grid, const FreeEnd& end, float nearest) const;
    bool join_line_ahead(const Grid& grid, const FreeEnd& end, float nearest);
    void join_pair(const Grid& grid, const FreeEnd& a, const FreeEnd& b);
    void close_gaps();
    void contract_links();
    void place_crossings();
    void remove_points();
    [[nodiscard]] bool is_spur(const Chain& chain) const;
    [[nodiscard]] bool is_superfluous(std::uint32_t index) const;
    void count_spurs();
    [[nodiscard]] bool too_short(const Chain& chain) const;
    void remove_line(const Chain& chain);
    void prune();
    void write_lines();
    void lengthen_dots();
};

} // namespace hachure::geometry
