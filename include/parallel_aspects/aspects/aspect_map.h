// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ASPECT_MAP_H
#define PARALLEL_ASPECTS_ASPECTS_ASPECT_MAP_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

class PoseTree;

/// What to compute. Every value has a default that suits the robot.
struct MapOptions {
  /// No undecided leaf of the base map has an edge longer than this [m or rad]; positive.
  /// By default `default_resolution`.
  std::optional<double> resolution;

  /// Where to look: a box of positions [m], over all orientations, of a slice the free ones; by default one
  /// that encloses every reachable pose. Rounded outward to binary fractions. Not used in SO3.
  std::optional<Box> region;

  /// What is mapped in place of all poses; by default all of them. Needed in SE3.
  std::optional<MapSlice> slice;

  /// Which working modes are mapped; by default every one that the kinds of the legs allow.
  std::vector<WorkingMode> modes;

  /// Worker threads; 0 for one a core. The result does not depend on it.
  unsigned threads = 0;

  /// How many times contested leaves may be halved below the resolution, 0 to 20.
  int extra_levels = 12;

  /// Whether a map of all poses with three degrees of freedom looks into every leaf in which an aspect could
  /// hide that is smaller than the resolution, so that `AspectMap::count_at_most` may be known. That takes
  /// many times as long as the rest (docs/theory/maps.md). With fewer degrees of freedom all maps do so,
  /// slices never.
  bool complete = false;

  /// Whether what symmetries of the robot show to be the same is computed only once (docs/theory/maps.md).
  /// Not in slices.
  bool use_symmetry = true;
};

/// A proved connected singularity-free set of one working mode and one sign of det A: part of exactly one
/// generalized aspect A_ij (Definition 6 of the paper), and all of it that the resolution shows.
struct Aspect {
  int id = 0;        ///< from 1: by mode index, then positive before negative det A, then falling measure
  WorkingMode mode;  ///< one sign a leg
  int determinant_sign = 0;  ///< +1 or -1

  /// Best estimate of the volume of its workspace projection WA_ij, in the unit of `measure_unit`. (In SO3
  /// volumes are taken at the centers of leaves.)
  double measure = 0.0;

  /// Its lower bound: the volume of its inside leaves.
  double measure_lower = 0.0;

  /// Its upper bound, with every undecided leaf that could belong to it and with every aspect that it is not
  /// proved separate from.
  double measure_upper = 0.0;

  std::size_t inside_leaves = 0;  ///< leaves of the tree that are proved to lie in it
  Box bounds;                     ///< of the inside leaves, in pose coordinates; of dimension 0 in SO3

  /// Center of the largest ball found in the inside leaves.
  Pose deepest;

  /// Radius of that ball: no singularity or limit is closer. In m, with rotations of SE2 weighted by the
  /// characteristic length; in SO3 in rad.
  double deepest_clearance = 0.0;

  /// Ids that could be the same aspect; empty when proved separate from all others.
  std::vector<int> unresolved_with;
};

/// What symmetries of the robot saved a computation.
struct SymmetryUse {
  std::vector<std::string> motions;  ///< what becomes of a point of the base in each, as "(x, -y)"
  std::size_t computed_modes = 0;    ///< working modes whose components are not images of others
};

/// What a map knows of a configuration.
enum class LocationStatus {
  inside,      ///< proved: `aspect` holds the pose
  undecided,   ///< closer to a singularity or a limit than the map can decide
  outside,     ///< proved: this working mode does not reach the pose, or not within limits
  not_mapped,  ///< outside the region of the map, or not finite
};

/// Where a configuration lies in a map.
struct Location {
  LocationStatus status = LocationStatus::not_mapped;  ///< what is known of it
  int aspect = 0;                                      ///< id, where inside

  /// Whether `aspect` is proved to hold the configuration.
  explicit operator bool() const noexcept { return status == LocationStatus::inside; }
};

/// The generalized aspects of a manipulator, certified: a 2^d-tree of pose boxes, each proved inside one sign
/// of det A, proved outside, or undecided, for each working mode. Immutable; may be read from any number of
/// threads.
class AspectMap {
 public:
  struct Contents;                                               ///< what the computation hands over
  explicit AspectMap(std::unique_ptr<const Contents> contents);  ///< takes what was computed or loaded
  ~AspectMap();
  AspectMap(const AspectMap&) = delete;
  AspectMap& operator=(const AspectMap&) = delete;

  const std::shared_ptr<const Manipulator>& manipulator() const noexcept;  ///< whose map it is; never null

  /// What was mapped in place of all poses; nothing where all of them were.
  const std::optional<MapSlice>& slice() const noexcept;
  std::vector<std::string> coordinates() const;  ///< of its boxes, by name; of none in SO3
  std::string unit() const;                      ///< of its measures

  Box region() const noexcept;                                     ///< what was searched
  double resolution() const noexcept;                              ///< longest edge of a base leaf [m or rad]
  const std::vector<WorkingMode>& working_modes() const noexcept;  ///< those with at least one inside leaf

  /// All aspects found; `aspect(id)` is `aspects()[id - 1]`.
  const std::vector<Aspect>& aspects() const noexcept;

  /// Lower bound of the number of generalized aspects, proved: inside components no two of which could be
  /// one.
  std::size_t proved_count() const noexcept;

  /// Upper bound of the number of generalized aspects that have a pose in the region, proved; none where
  /// `indeterminate_leaves` is not zero.
  std::optional<std::size_t> count_at_most() const noexcept;

  /// Undecided leaves, counted by mode and sign of det A, of which it is not proved that what they hold lies
  /// in one aspect at most: aspects that are not listed could hide there. With one and two degrees of freedom
  /// they are divided until none is left, or down to the deepest level.
  std::size_t indeterminate_leaves() const noexcept;

  /// Pairs of `aspects()` that are neither joined nor proved separate.
  const std::vector<std::pair<int, int>>& unresolved() const noexcept;

  /// Total volume of undecided leaves over all working modes: what could hide aspects too small to see.
  double measure_undecided() const noexcept;

  /// Time that the computation took [s].
  double seconds() const noexcept;

  /// Which symmetries were used; nothing where the map was loaded from a file.
  const std::optional<SymmetryUse>& symmetry_use() const noexcept;

  /// Which aspect holds this pose in this working mode; in an undecided leaf, by proving a straight path to
  /// an inside leaf near by. Neither allocates nor throws.
  Location locate(const Pose& pose, const WorkingMode& mode) const noexcept;

  /// Calls `visit` with every inside leaf of an aspect.
  void visit_inside_leaves(int aspect, const std::function<void(const Box&)>& visit) const;

  /// Calls `visit` with the pose at the center of every inside leaf of an aspect, and the volume of the leaf
  /// in the unit of `measure_unit`.
  void visit_inside_poses(int aspect, const std::function<void(const Pose&, double measure)>& visit) const;

  /// Calls `visit` with every undecided leaf of a working mode.
  void visit_undecided_leaves(const WorkingMode& mode, const std::function<void(const Box&)>& visit) const;

  /// All of it, as `save_map` writes it.
  const Contents& contents() const noexcept { return *contents_; }

 private:
  std::unique_ptr<const Contents> contents_;
};

/// A map, or why there is none.
struct MapResult {
  MapStatus status = MapStatus::refused;  ///< how the computation ended
  std::string message;                    ///< why, unless complete
  std::shared_ptr<const AspectMap> map;   ///< set when complete

  explicit operator bool() const noexcept { return map != nullptr; }  ///< whether there is a map
};

/// Computes the map, of a slice in SE3 and of all poses or of a slice elsewhere. SE3 without a slice and bad
/// options are refused with a message.
MapResult compute_aspect_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options = {},
                             const MapControl& control = {});

/// The resolution that is taken where none is given: 1/200 of the robot's size in T2, 1/50 in SE2 and T3 [m],
/// 0.1 rad in SO3; in slices 1/200 of the robot's size for one or two free coordinates and 1/50 for three
/// [m], or where no position is free 0.01 rad for an angle and 0.1 rad for orientations. Angles beside
/// positions are taken to 0.1 rad then, with one position to 0.025 rad, whatever the unit of length.
double default_resolution(const Manipulator& manipulator,
                          const std::optional<MapSlice>& slice = std::nullopt) noexcept;

/// Whether a map was written.
struct SaveResult {
  bool saved = false;   ///< the file is whole and on the disk
  std::string message;  ///< why not, unless saved

  explicit operator bool() const noexcept { return saved; }  ///< whether it was written
};

/// Why a map cannot be saved there, such as "is in no folder that can be written to"; empty where it can.
/// What is no map is not written over.
std::string problem_of_saving(const std::string& path);

/// Writes the map to a file, and its graph of aspects if that is known (`compute_aspect_graph`): who loads it
/// need not search for gates again. At every moment the file is the old one or the new one, whole.
SaveResult save_map(const AspectMap& map, const std::string& path);

/// The map of this manipulator with these options, as `compute_aspect_map` gave it, if the file holds that;
/// where `complete` is not asked for, one that is will do.
/// Refused with a message where it cannot be read, is damaged, is of another version of the package or
/// another revision of the proofs, or holds the map of another robot or of other options. What the file
/// claims is believed then, so it is as good as those who can write to it; but no file, not even a forged
/// one, does harm beyond wrong answers.
MapResult load_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                   const std::string& path);

/// The file that `save_map` writes, packed by zlib behind its length, a little-endian number of eight bytes.
std::vector<std::uint8_t> map_bytes(const AspectMap& map);

/// The map that such bytes are of, refused like a file.
MapResult map_from_bytes(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                         const std::vector<std::uint8_t>& bytes);

/// Options that the map is loaded with, for whoever does not know those that it was computed with.
MapOptions options_of(const AspectMap& map);

/// The undecided leaves, over all working modes, in which a constraint neither holds everywhere nor fails
/// everywhere: what encloses its boundary. One leaf may enclose several.
struct ConstraintBoundary {
  ConstraintKind kind = ConstraintKind::actuated_limits;  ///< whose boundary it is
  std::size_t leaves = 0;                                 ///< how many there are
  double measure = 0.0;                                   ///< of these leaves, in the unit of `measure_unit`
};

/// One for each constraint that the map was computed with, in the order of `all_constraint_kinds`.
std::vector<ConstraintBoundary> constraint_boundaries(const AspectMap& map);

/// Working modes in which no pose is proved to be free of singularities.
struct MissingModes {
  std::vector<WorkingMode> empty;    ///< proved: no pose of the region is in an aspect of it
  std::vector<WorkingMode> unknown;  ///< undecided leaves are left
};

/// Those of the modes that the map was computed for.
MissingModes missing_modes(const AspectMap& map);

/// Whether the region of the map may leave out poses that legs reach in the workspace. Then aspects are
/// connected within the region, and one of the robot that it cuts may be counted as several.
bool is_cut_by_region(const AspectMap& map);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ASPECT_MAP_H
