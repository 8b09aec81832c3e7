#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/sparse_system.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace hachure::geometry {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

/// Equations that are factorised as they are ordered.
template <class Scalar> struct Equations {
    std::vector<Eigen::Triplet<Scalar>> entries;
    std::vector<std::size_t> places; ///< per unknown
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<Scalar>, Eigen::Lower, Eigen::NaturalOrdering<int>> solver;
    mutable Eigen::Matrix<Scalar, Eigen::Dynamic, 1> scratch;

    /// In the lower triangle, by places.
    void add(std::size_t row, std::size_t column, Scalar value) {
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    }

    bool factorise() {
        const auto size = static_cast<Eigen::Index>(places.size());
        Eigen::SparseMatrix<Scalar> matrix(size, size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        entries = {};
        if (size == 0) return true;
        solver.compute(matrix);
        return solver.info() == Eigen::Success && solver.vectorD().real().minCoeff() > 0.0;
    }

    void solve(std::span<const Scalar> right, std::span<Scalar> x) const {
        HACHURE_ASSERT(right.size() == places.size() && x.size() == places.size(), "one number per unknown");
        if (places.empty()) return;
        scratch.resize(static_cast<Eigen::Index>(places.size()));
        for (std::size_t i = 0; i < places.size(); ++i) scratch[static_cast<Eigen::Index>(places[i])] = right[i];
        const Eigen::Matrix<Scalar, Eigen::Dynamic, 1> solution = solver.solve(scratch);
        for (std::size_t i = 0; i < places.size(); ++i) x[i] = solution[static_cast<Eigen::Index>(places[i])];
    }
};

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

struct SparseSystem::Factors : Equations<double> {};
struct HermitianSystem::Factors : Equations<std::complex<double>> {};

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
    factors_->add(std::max(p, q), std::min(p, q), value);
}

bool SparseSystem::factorise() { return factors_->factorise(); }

void SparseSystem::solve(std::span<const double> right, std::span<double> x) const { factors_->solve(right, x); }

HermitianSystem::HermitianSystem(std::span<const std::uint32_t> order) : factors_(std::make_unique<Factors>()) {
    factors_->places.assign(order.begin(), order.end());
}

HermitianSystem::~HermitianSystem() = default;
HermitianSystem::HermitianSystem(HermitianSystem&&) noexcept = default;
HermitianSystem& HermitianSystem::operator=(HermitianSystem&&) noexcept = default;

void HermitianSystem::add(std::size_t a, std::size_t b, std::complex<double> value) {
    const std::size_t p = factors_->places[a], q = factors_->places[b];
    factors_->add(std::max(p, q), std::min(p, q), p < q ? std::conj(value) : value);
}

bool HermitianSystem::factorise() { return factors_->factorise(); }

void HermitianSystem::solve(std::span<const std::complex<double>> right, std::span<std::complex<double>> x) const {
    factors_->solve(right, x);
}

} // namespace hachure::geometry
