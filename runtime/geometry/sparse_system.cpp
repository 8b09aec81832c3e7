#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/sparse_system.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace hachure::geometry {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

} // namespace

std::vector<std::uint32_t> elimination_order(std::size_t vertices,
                                             std::span<const std::array<std::uint32_t, 2>> edges) {
    if (vertices == 0) return {};
    std::vector<Triplet> entries;
    entries.reserve(vertices + edges.size());
    for (std::size_t v = 0; v < vertices; ++v) entries.emplace_back(static_cast<int>(v), static_cast<int>(v), 1.0);
    for (const auto& [a, b] : edges)
        entries.emplace_back(static_cast<int>(std::max(a, b)), static_cast<int>(std::min(a, b)), 1.0);
    Matrix graph(static_cast<Eigen::Index>(vertices), static_cast<Eigen::Index>(vertices));
    graph.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
    std::vector<std::uint32_t> places(vertices);
    for (std::size_t i = 0; i < vertices; ++i)
        places[static_cast<std::size_t>(order.indices()[static_cast<Eigen::Index>(i)])] = static_cast<std::uint32_t>(i);
    return places;
}

struct SparseSystem::Factors {
    std::vector<Triplet> entries;
    std::vector<std::size_t> places; ///< per unknown
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> solver;
    mutable Eigen::VectorXd scratch;
};

SparseSystem::SparseSystem(std::span<const std::uint32_t> order, std::size_t block)
    : factors_(std::make_unique<Factors>()) {
    factors_->places.resize(order.size() * block);
    for (std::size_t v = 0; v < order.size(); ++v)
        for (std::size_t k = 0; k < block; ++k) factors_->places[block * v + k] = block * order[v] + k;
}

SparseSystem::~SparseSystem() = default;
SparseSystem::SparseSystem(SparseSystem&&) noexcept = default;
SparseSystem& SparseSystem::operator=(SparseSystem&&) noexcept = default;

void SparseSystem::add(std::size_t a, std::size_t b, double value) {
    const std::size_t p = factors_->places[a], q = factors_->places[b];
    factors_->entries.emplace_back(static_cast<int>(std::max(p, q)), static_cast<int>(std::min(p, q)), value);
}

bool SparseSystem::factorise() {
    const auto size = static_cast<Eigen::Index>(factors_->places.size());
    Matrix matrix(size, size);
    matrix.setFromTriplets(factors_->entries.begin(), factors_->entries.end());
    factors_->entries = {};
    if (size == 0) return true;
    factors_->solver.compute(matrix);
    return factors_->solver.info() == Eigen::Success && factors_->solver.vectorD().minCoeff() > 0.0;
}

void SparseSystem::solve(std::span<const double> right, std::span<double> x) const {
    const std::vector<std::size_t>& places = factors_->places;
    HACHURE_ASSERT(right.size() == places.size() && x.size() == places.size(), "one number per unknown");
    if (places.empty()) return;
    Eigen::VectorXd& b = factors_->scratch;
    b.resize(static_cast<Eigen::Index>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) b[static_cast<Eigen::Index>(places[i])] = right[i];
    const Eigen::VectorXd solution = factors_->solver.solve(b);
    for (std::size_t i = 0; i < places.size(); ++i) x[i] = solution[static_cast<Eigen::Index>(places[i])];
}

} // namespace hachure::geometry
