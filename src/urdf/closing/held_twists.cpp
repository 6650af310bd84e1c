// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "urdf/closing/chain.h"

#include <map>

namespace parallel_aspects {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

// What is orthogonal to the columns.
TwistMatrix complement(const MatrixXd& columns) {
  const auto svd = singular_value_decomposition(columns);
  const Index rank = svd.rank_above(rank_tolerance);
  return TwistMatrix::Identity() - product(svd.u.leftCols(rank), svd.u.leftCols(rank).transpose());
}

// Twists about the origin of the base, a column each.
MatrixXd twists_of(const Chain& pivots, double size) {
  std::vector<Eigen::Matrix<double, 6, 1>> columns;
  for (const Pivot& pivot : pivots)
    for (Index k = 0; k < (pivot.kind == PivotKind::ball ? 3 : 1); ++k) {
      const Vector3d axis = pivot.kind == PivotKind::ball ? Vector3d(Vector3d::Unit(k)) : pivot.axis;
      Eigen::Matrix<double, 6, 1> twist;
      if (pivot.kind == PivotKind::prismatic)
        twist << Vector3d::Zero(), axis;
      else
        twist << axis, (pivot.point / size).cross(axis);
      columns.push_back(twist);
    }
  MatrixXd result(6, static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) result.col(static_cast<Index>(k)) = columns[k];
  return result;
}

}  // namespace

// For each joint, twist(to) - twist(from) is one of its own: what is orthogonal to those is zero.
TwistMatrix held_twists(const std::vector<Edge>& edges, std::size_t base, std::size_t platform, double size) {
  std::map<std::size_t, Index> places{{platform, 0}};
  for (const Edge& edge : edges)
    for (const std::size_t body : {edge.from, edge.to})
      if (body != base) places.emplace(body, 6 * static_cast<Index>(places.size()));
  MatrixXd equations =
      MatrixXd::Zero(6 * static_cast<Index>(edges.size()), 6 * static_cast<Index>(places.size()));
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const TwistMatrix held = complement(twists_of(edges[k].pivots, size));
    const Index row = 6 * static_cast<Index>(k);
    if (edges[k].to != base) equations.block<6, 6>(row, places[edges[k].to]) += held;
    if (edges[k].from != base) equations.block<6, 6>(row, places[edges[k].from]) -= held;
  }
  const auto svd = singular_value_decomposition(equations);
  const MatrixXd allowed = svd.null_space(svd.rank_above(rank_tolerance));
  return allowed.cols() > 0 ? complement(allowed.topRows<6>()) : TwistMatrix(TwistMatrix::Identity());
}

Index freedom_left(const std::vector<TwistMatrix>& held) {
  if (held.empty()) return 6;
  MatrixXd all(6 * static_cast<Index>(held.size()), 6);
  for (std::size_t k = 0; k < held.size(); ++k) all.middleRows<6>(6 * static_cast<Index>(k)) = held[k];
  return 6 - (singular_values(all).array() > rank_tolerance).count();
}

}  // namespace parallel_aspects
