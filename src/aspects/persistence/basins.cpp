// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/persistence/deepest_index.h"
#include "aspects/persistence/index_cells.h"
#include "aspects/persistence/merge_tree.h"
#include "aspects/persistence/mode_images.h"
#include "parallel_aspects/aspects/connectivity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

// A cell is not halved if its bounds of the index are closer than this, unless that may raise the largest
// index of an aspect.
constexpr double fine_enough = 0.05;  // as a share of the upper one

/// In what is listed by aspect.
std::size_t place_of(int id) { return static_cast<std::size_t>(id - 1); }

/// Basins of one working mode and one sign of det A.
class SignBasins {
 public:
  SignBasins(const AspectMap& map, std::size_t mode, int sign, ParallelIndex index, const MapControl& control)
      : map_(map), contents_(map.contents()), what_{mode, sign, index}, control_(control) {
    for (const Aspect& aspect : map.aspects())
      if (aspect.mode == contents_.modes[mode] && aspect.determinant_sign == sign) ids_.push_back(aspect.id);
    for (std::size_t i = 0; i < map.unresolved().size(); ++i)
      if (std::count(ids_.begin(), ids_.end(), map.unresolved()[i].first) > 0) pairs_.push_back(i);
  }

  /// Its basins, whose places count from the first of them. Writes the rest into `basins`.
  std::vector<Basin> find(BasinDetail detail, MapBasins& basins) {
    if (ids_.empty()) return {};
    const std::map<int, IndexPeak> peaks = find_index_peaks(contents_, what_, control_);
    if (is_cancelled(control_)) return {};
    if (detail == BasinDetail::depths && pairs_.empty() && region_bounds(peaks, basins)) return {};
    IndexCells cells(contents_, what_);
    if (detail == BasinDetail::basins) divide_coarse(cells);
    DeepestIndex deepest(cells, peaks, control_);
    deepest.search();
    if (is_cancelled(control_)) return {};
    for (const auto& [id, range] : deepest.ranges()) basins.deepest[place_of(id)] = range;
    bound_pairs(cells, basins);
    if (detail == BasinDetail::depths) return {};
    cells.bound_all();
    return basins_of(cells, listed(merge(cells, edges_of(cells, PathBound::upper)), cells), basins);
  }

 private:
  /// Whether the largest index in the region of the map, which takes next to no time, bounds those of the
  /// aspects precisely enough; as where they come close to the largest that there is.
  bool region_bounds(const std::map<int, IndexPeak>& peaks, MapBasins& basins) const {
    const double largest = largest_in_region(contents_, what_);
    for (const auto& [id, peak] : peaks) {
      if (!is_precise(largest, peak.index, contents_.tree.dimension(), what_.index)) return false;
      basins.deepest[place_of(id)] = {peak.index, largest};
    }
    return true;
  }

  /// Inside leaves are as large as the proof of their sign permits, but bounds of the index need smaller
  /// ones. Where the index is small, its bounds may be farther apart.
  void divide_coarse(IndexCells& all) const {
    all.bound_all();
    std::vector<NodeIndex> cells = all.all();
    double largest = 0.0;
    for (const NodeIndex cell : cells) largest = std::max(largest, all.lower(cell));
    const auto is_done = [this, largest, &all](NodeIndex cell) {
      const double upper = all.upper(cell), gap = upper - all.lower(cell);
      return !all.is_inside(cell) || gap <= fine_enough * std::max(upper, largest) ||
             all.tree().place(cell).level >= contents_.depth;
    };
    while (!cells.empty() && !is_cancelled(control_)) {
      cells.erase(std::remove_if(cells.begin(), cells.end(), is_done), cells.end());
      cells = all.divide(cells);
    }
  }

  /// The largest index that could join the aspects of each unresolved pair.
  void bound_pairs(const IndexCells& cells, MapBasins& basins) const {
    if (pairs_.empty()) return;
    std::vector<std::pair<int, int>> pairs;
    for (const std::size_t i : pairs_) pairs.push_back(map_.unresolved()[i]);
    const std::vector<double> levels = AspectLinks(cells, pairs, control_).levels();
    for (std::size_t i = 0; i < pairs.size(); ++i)
      basins.bottlenecks[pairs_[i]] = {0.0,
                                       std::min({levels[i], basins.deepest[place_of(pairs[i].first)].upper,
                                                 basins.deepest[place_of(pairs[i].second)].upper})};
  }

  /// Halved cells may show a peak that belongs to no aspect of the map.
  static std::vector<PeakMerge> listed(std::vector<PeakMerge> merges, const IndexCells& cells) {
    const auto is_unlisted = [&cells](const PeakMerge& merge) {
      return cells.aspect(merge.peak) == 0 || cells.aspect(merge.higher) == 0;
    };
    merges.erase(std::remove_if(merges.begin(), merges.end(), is_unlisted), merges.end());
    return merges;
  }

  std::vector<Basin> basins_of(const IndexCells& cells, const std::vector<PeakMerge>& merges,
                               const MapBasins& depths) const {
    std::vector<std::pair<NodeIndex, NodeIndex>> ends;
    for (const PeakMerge& merge : merges) ends.emplace_back(merge.peak, merge.higher);
    const std::vector<double> lower =
        levels_of_joining(cells.tree().node_count(), edges_of(cells, PathBound::lower), ends);
    std::vector<Basin> basins;
    std::map<NodeIndex, std::size_t> place;  // in the list, by peak
    for (const NodeIndex peak : roots_and_peaks(cells, merges)) {
      place.emplace(peak, basins.size());
      basins.push_back(basin_at(cells, peak));
      basins.back().depth.upper = depths.deepest[place_of(basins.back().aspect)].upper;
    }
    for (std::size_t i = 0; i < merges.size(); ++i) {
      Basin& basin = basins[place.at(merges[i].peak)];
      basin.deeper = place.at(merges[i].higher);
      basin.saddle = {lower[i], merges[i].level};
      basin.depth.upper = std::min(basin.depth.upper, merges[i].largest);
    }
    return basins;
  }

  /// Every peak of the merges, and the highest peak of each aspect that has none among them; the highest
  /// first.
  std::vector<NodeIndex> roots_and_peaks(const IndexCells& cells,
                                         const std::vector<PeakMerge>& merges) const {
    std::vector<NodeIndex> peaks;
    std::map<int, NodeIndex> highest;
    for (const NodeIndex cell : cells.all()) {
      if (cells.aspect(cell) == 0) continue;
      const auto known = highest.try_emplace(cells.aspect(cell), cell).first;
      if (cells.lower(cell) > cells.lower(known->second)) known->second = cell;
    }
    for (const auto& [id, cell] : highest) peaks.push_back(cell);
    for (const PeakMerge& merge : merges) peaks.insert(peaks.end(), {merge.peak, merge.higher});
    std::sort(peaks.begin(), peaks.end());
    peaks.erase(std::unique(peaks.begin(), peaks.end()), peaks.end());
    std::stable_sort(peaks.begin(), peaks.end(),
                     [&cells](NodeIndex a, NodeIndex b) { return cells.lower(a) > cells.lower(b); });
    return peaks;
  }

  Basin basin_at(const IndexCells& cells, NodeIndex peak) const {
    const PoseTree& tree = cells.tree();
    const MapPosition middle{tree.place(peak).root, tree.box(peak).middle()};
    Basin basin;
    basin.aspect = cells.aspect(peak);
    basin.deepest = tree.space().pose(middle);
    basin.depth = {std::max(cells.lower(peak), cells.at(middle).lower), cells.upper(peak)};
    return basin;
  }

  const AspectMap& map_;
  const AspectMap::Contents& contents_;
  IndexOfMode what_;
  const MapControl& control_;
  std::vector<int> ids_;
  std::vector<std::size_t> pairs_;  // of unresolved ones, by their places
};

}  // namespace

namespace {

/// Behind the others, which they do not refer to.
void append(std::vector<Basin> more, std::vector<Basin>& basins) {
  const std::size_t before = basins.size();
  for (Basin& basin : more) {
    if (basin.deeper) *basin.deeper += before;
    basins.push_back(basin);
  }
}

std::vector<ModeImage> all_by_themselves(std::size_t modes) {
  std::vector<ModeImage> images(modes);
  for (std::size_t mode = 0; mode < modes; ++mode) images[mode].representative = mode;
  return images;
}

/// An index is the same at the image of a pose.
void copy_to_image(const AspectMap& map, const ModeImage& image, MapBasins& basins) {
  for (const auto& [from, to] : image.aspects) basins.deepest[place_of(to)] = basins.deepest[place_of(from)];
  const auto& pairs = map.unresolved();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto a = image.aspects.find(pairs[i].first), b = image.aspects.find(pairs[i].second);
    if (a == image.aspects.end() || b == image.aspects.end()) continue;
    const std::pair<int, int> ids = std::minmax(a->second, b->second);
    const auto place = std::find(pairs.begin(), pairs.end(), ids);
    basins.bottlenecks[static_cast<std::size_t>(place - pairs.begin())] = basins.bottlenecks[i];
  }
}

}  // namespace

std::optional<MapBasins> find_basins(const AspectMap& map, ParallelIndex index, BasinDetail detail,
                                     const MapControl& control) {
  const std::size_t modes = map.contents().modes.size();
  // Basins have poses, of which no images are made.
  const std::vector<ModeImage> images =
      detail == BasinDetail::depths ? find_mode_images(map.contents()) : all_by_themselves(modes);
  std::vector<std::vector<Basin>> found(2 * modes);  // by mode, positive before negative
  MapBasins basins;
  basins.index = index;
  basins.deepest.assign(map.aspects().size(), {0.0, 0.0});
  basins.bottlenecks.assign(map.unresolved().size(), {0.0, 0.0});
  // Each writes to the entries of its own aspects only.
  tbb::parallel_for(std::size_t{0}, 2 * modes, [&](std::size_t i) {
    if (!is_cancelled(control) && images[i / 2].representative == i / 2)
      found[i] = SignBasins(map, i / 2, i % 2 == 0 ? 1 : -1, index, control).find(detail, basins);
  });
  if (is_cancelled(control)) return std::nullopt;
  for (const ModeImage& image : images) copy_to_image(map, image, basins);
  for (std::vector<Basin>& each : found) append(std::move(each), basins.basins);
  return basins;
}

const char* name(ParallelIndex index) noexcept {
  return index == ParallelIndex::normalised ? "parallel" : "det_a";
}

}  // namespace parallel_aspects
