// A two-level preconditioner, with which conjugate gradients converge in few steps on a large mesh.
#pragma once

#include <Eigen/SparseCholesky>
#include <cmath>
#include <complex>
#include <cstdint>
#include <vector>

#include "server/groom/cancel.h"

namespace pelage {

/// A preconditioner for Eigen, for Hermitian matrices of a mesh whose off-diagonal entries transport a value from one
/// vertex to another. In addition to the diagonal it inverts the matrix on groups of vertices, each of which takes its
/// value from its first vertex (additive Schwarz with aggregates). Deterministic.
template <class Number>
class TwoLevel {
 public:
  using Matrix = Eigen::SparseMatrix<Number>;
  using Vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;
  using StorageIndex = typename Matrix::StorageIndex;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic };

  /// Keeps a reference to `cancel`, which is polled at each step; Cancelled is thrown out of the solver.
  void set_cancel(const Cancel& cancel) { cancel_ = &cancel; }

  TwoLevel& analyzePattern(const Matrix&) { return *this; }
  TwoLevel& factorize(const Matrix& matrix) { return compute(matrix); }
  TwoLevel& compute(const Matrix& matrix) {
    inverse_ = matrix.diagonal().cwiseInverse();
    aggregate(matrix);
    std::vector<Eigen::Triplet<Number>> entries;
    entries.reserve(static_cast<std::size_t>(matrix.nonZeros()));
    for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
      for (typename Matrix::InnerIterator entry(matrix, column); entry; ++entry)
        entries.emplace_back(group_[entry.row()], group_[column],
                             Eigen::numext::conj(transport_[entry.row()]) * entry.value() * transport_[column]);
    }
    Matrix coarse(groups_, groups_);
    coarse.setFromTriplets(entries.begin(), entries.end());
    coarse_.compute(coarse);
    return *this;
  }

  Vector solve(const Vector& right) const {
    if (cancel_) cancel_->check();
    Vector sums = Vector::Zero(groups_);
    for (Eigen::Index v = 0; v < right.size(); ++v) sums[group_[v]] += Eigen::numext::conj(transport_[v]) * right[v];
    const Vector moves = coarse_.solve(sums);
    Vector result = inverse_.cwiseProduct(right);
    for (Eigen::Index v = 0; v < right.size(); ++v) result[v] += transport_[v] * moves[group_[v]];
    return result;
  }

  Eigen::ComputationInfo info() const { return coarse_.info(); }

 private:
  /// Collects groups of neighbours, breadth first.
  void aggregate(const Matrix& matrix) {
    constexpr Eigen::Index groups = 20'000;
    const auto group_size = static_cast<std::size_t>(matrix.rows() / groups + 1);
    group_.assign(static_cast<std::size_t>(matrix.rows()), -1);
    transport_ = Vector::Ones(matrix.rows());
    groups_ = 0;
    std::vector<Eigen::Index> members;
    for (Eigen::Index seed = 0; seed < matrix.rows(); ++seed) {
      if (group_[seed] >= 0) continue;
      members.assign(1, seed), group_[seed] = groups_;
      for (std::size_t i = 0; i < members.size() && members.size() < group_size; ++i) {
        for (typename Matrix::InnerIterator entry(matrix, members[i]); entry && members.size() < group_size; ++entry) {
          const double coupled = std::abs(entry.value());
          if (group_[entry.row()] >= 0 || !(coupled > 0)) continue;
          group_[entry.row()] = groups_, members.push_back(entry.row());
          transport_[entry.row()] = -entry.value() / coupled * transport_[members[i]];
        }
      }
      ++groups_;
    }
  }

  const Cancel* cancel_ = nullptr;
  Vector inverse_;          // reciprocals of the matrix's diagonal
  std::vector<int> group_;  // group of each vertex
  Vector transport_;        // for each vertex, the value 1 at its group's first vertex, transported to it
  int groups_ = 0;
  Eigen::SimplicialLDLT<Matrix> coarse_;
};

}  // namespace pelage
