// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_GATE_CLASSES_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_GATE_CLASSES_H

#include "aspects/map/leaf_crossings.h"
#include "aspects/map/map_contents.h"
#include "aspects/symmetry/map_symmetry.h"
#include "parallel_aspects/aspects/neighbours.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_GATE_CLASSES_H
