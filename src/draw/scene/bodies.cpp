// SPDX-License-Identifier: BSD-3-Clause
#include "draw/scene/bodies.h"

#include <cmath>
#include <iterator>
#include <utility>

namespace parallel_aspects {
namespace {

template <class Value>
void append_all(std::vector<Value>&& values, std::vector<Value>& to) {
  to.insert(to.end(), std::make_move_iterator(values.begin()), std::make_move_iterator(values.end()));
}

}  // namespace

Eigen::Vector3d JointTile::drawn(const JointVector& q) const {
  Eigen::Vector3d values = middle;
  for (Eigen::Index i = 0; i < std::min<Eigen::Index>(3, q.size()); ++i)
    values[i] = turns[static_cast<std::size_t>(i)] ? std::remainder(q[i], 2.0 * EIGEN_PI) : q[i];
  return at + scale.cwiseProduct(values - middle);
}

void move(PicturePart& part, double scale, const Eigen::Vector3d& offset) {
  const auto move_point = [factor = static_cast<float>(scale), by = Eigen::Vector3f(offset.cast<float>())](
                              Eigen::Vector3f& point) { point = factor * point + by; };
  for (ColoredMesh& mesh : part.meshes)
    for (Eigen::Vector3f& point : mesh.points) move_point(point);
  for (ColoredLines& lines : part.lines)
    for (Eigen::Vector3f& point : lines.ends) move_point(point);
  for (Label& label : part.labels) move_point(label.at);
}

void append(PicturePart&& part, PicturePart& to) {
  append_all(std::move(part.meshes), to.meshes);
  append_all(std::move(part.lines), to.lines);
  append_all(std::move(part.labels), to.labels);
}

}  // namespace parallel_aspects
