// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_GATE_CROSSINGS_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_GATE_CROSSINGS_H

#include "aspects/boxes/segment_proof.h"
#include "aspects/map/map_contents.h"
#include "aspects/symmetry/map_symmetry.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// `GateCrossing::index` of a crossing that begins there, of B_jj = 0 of a leg or of det A = 0: the least
/// index of other singularities and of what is left to limits; -1 where a leg does not reach.
double crossing_index(const Manipulator& robot, const Pose& pose, const WorkingMode& mode, Crossing crossing,
                      std::size_t leg);

/// Where two aspects come close to each other in a leaf.
struct LeafCrossing {
  int from = 0, to = 0;  ///< ids; the path begins in the first, a serial one in both
  bool proved = false;   ///< whether the path is a crossing, as `Neighbours` says
  CrossingPath path;
};

/// In an undecided leaf in which no B_jj vanishes: from positive det A to negative. Needs, as the other, a
/// live `RoundingUpward`.
std::optional<LeafCrossing> find_parallel_crossing(const MarkedMap& map, NodeIndex leaf, std::size_t mode);

/// In an undecided leaf in which B_jj of one leg alone may vanish: between working modes that differ in it,
/// where det A has this sign.
std::optional<LeafCrossing> find_serial_crossing(const MarkedMap& map, NodeIndex leaf, std::size_t mode,
                                                 std::size_t other_mode, std::size_t leg, int sign);

/// The ends of the segments of a path.
std::vector<Pose> poses_of(const PoseSpace& space, const CrossingPath& path);

/// The middle of a path, or where it goes through a glued face.
Pose middle_of(const PoseSpace& space, const CrossingPath& path);

/// All gates through one singularity of one working mode; where serial, of one in which B_jj of the leg has
/// the sign +1, to that in which it has the other.
struct GateClass {
  Crossing crossing = Crossing::parallel;
  std::size_t mode = 0;
  std::size_t leg = 0;  ///< 0 where parallel

  friend bool operator==(const GateClass& a, const GateClass& b) noexcept {
    return a.crossing == b.crossing && a.mode == b.mode && a.leg == b.leg;
  }
};

/// The mode at the other side; nothing where there is none.
std::optional<std::size_t> other_mode(const AspectMap::Contents& map, const GateClass& gates);

/// Which gates are searched, and which are taken to be their images. Where they are is then proved of each.
class GateClasses {
 public:
  explicit GateClasses(const AspectMap::Contents& map);
  GateClasses(const GateClasses&) = delete;
  GateClasses& operator=(const GateClasses&) = delete;

  struct Image {
    GateClass of, to;
    const MapSymmetry* symmetry;
  };

  /// Of classes that are searched.
  const std::vector<Image>& images() const noexcept { return images_; }

  bool is_searched(const GateClass& gates) const noexcept;

  /// Whether a class that is searched has this mode at one of its sides.
  bool is_needed(std::size_t mode) const noexcept { return is_needed_[mode]; }

 private:
  void add(const AspectMap::Contents& map, const GateClass& gates);
  static std::optional<GateClass> image(const AspectMap::Contents& map, const MapSymmetry& symmetry,
                                        const GateClass& gates);

  std::vector<MapSymmetry> symmetries_;
  std::vector<GateClass> searched_;
  std::vector<Image> images_;
  std::vector<bool> is_needed_;
};

/// The image of a crossing of a gate with this sign of det A, where its ends are located, and whether it is
/// proved. Needs a live `RoundingUpward`.
std::optional<LeafCrossing> image_of(const MarkedMap& map, const LeafCrossing& crossing, int sign,
                                     const GateClasses::Image& image);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_GATE_CROSSINGS_H
