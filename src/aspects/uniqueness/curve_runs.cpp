// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/curve_runs.h"

#include "aspects/cusps/cusp_tube.h"
#include "interval/half_turns.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

// Pieces that are shorter are not divided; of those no point is listed where there is another [half turns].
constexpr double shortest_piece = 0x1p-32, shortest_with_point = 0x1p-12;

enum class PiecePlace { inside, outside, unknown };

/// A piece of a curve, of which some is proved all over it.
struct CurvePiece {
  PiecePlace place = PiecePlace::unknown;
  int direction = 0;  // of the held value, along the trace
  int held_sign = 0;  // of B_jj of the leg whose joint is held
  Interval held;      // coordinates
  double length = 0.0;
  std::optional<Box> point;
};

bool same_state(const CurvePiece& a, const CurvePiece& b) noexcept {
  if (a.place != b.place) return false;
  return a.place != PiecePlace::inside || (a.direction == b.direction && a.held_sign == b.held_sign);
}

/// The pieces of a trace, in its order.
class CurveDivision {
 public:
  CurveDivision(SliceFamily& family, const Interval& range) : family_(family), range_(range) {}

  std::vector<CurvePiece> pieces_of(const CuspTrace& trace, const MapControl& control) {
    for (std::size_t i = 0; i < trace.tubes.size() && !is_cancelled(control); ++i) {
      const Box &from = trace.points[i], &to = trace.points[(i + 1) % trace.points.size()];
      const CuspTube& tube = trace.tubes[i];
      const Interval first = along(tube, from), last = along(tube, to);
      const double sense = first.lower() < last.lower() ? 1.0 : -1.0;
      divide(tube, std::min(first.lower(), last.lower()), std::max(first.upper(), last.upper()), sense);
    }
    return std::move(pieces_);
  }

 private:
  void divide(const CuspTube& tube, double lower, double upper, double sense) {
    CurvePiece piece = piece_of(tube, lower, upper, sense);
    const double middle = 0.5 * (lower + upper);
    if (piece.place != PiecePlace::unknown || upper - lower < shortest_piece) {
      piece.length = upper - lower;
      pieces_.push_back(std::move(piece));
      return;
    }
    divide(tube, sense > 0.0 ? lower : middle, sense > 0.0 ? middle : upper, sense);
    divide(tube, sense > 0.0 ? middle : lower, sense > 0.0 ? upper : middle, sense);
  }

  CurvePiece piece_of(const CuspTube& tube, double lower, double upper, double sense) {
    CurvePiece piece;
    piece.held = held_within(tube, {lower, upper});
    const auto point = cusp_near(family_, tube.axis, middle_at(tube, 0.5 * (lower + upper)));
    if (!point || !contains(tube, *point)) return piece;
    const MapPoint at = point->middle();
    const auto part =
        tube_about(family_, tube.axis, at, std::max(upper - at[tube.axis], at[tube.axis] - lower));
    if (!part || !contains(*part, *point)) return piece;
    piece.point = point;
    set_state(*part, sense, piece);
    return piece;
  }

  void set_state(const CuspTube& part, double sense, CurvePiece& piece) {
    const Box hull = hull_of(part, intersection(part.cross, part.enclosed));
    piece.held = Interval(hull.lower[2], hull.upper[2]);
    if (hull.upper[2] < range_.lower() || hull.lower[2] > range_.upper() ||
        family_.within_limits(hull) == Verdict::fails) {
      piece.place = PiecePlace::outside;
      return;
    }
    if (hull.lower[2] < range_.lower() || hull.upper[2] > range_.upper() ||
        family_.within_limits(hull) != Verdict::holds)
      return;
    piece.direction = (sense > 0.0 ? 1 : -1) * held_direction(family_, part);
    piece.held_sign = family_.held_sign(hull);
    if (piece.direction != 0 && piece.held_sign != 0) piece.place = PiecePlace::inside;
  }

  /// Of the arc over a range of the parameter, by what is proved of the whole tube.
  static Interval held_within(const CuspTube& tube, const Interval& parameters) {
    if (tube.axis == 2) return parameters;
    const Box cross = intersection(tube.cross, tube.enclosed);
    return Interval(cross.lower[1], cross.upper[1]) +
           Interval(tube.slope[1]) * (parameters - Interval(tube.middle));
  }

  static MapPoint middle_at(const CuspTube& tube, double parameter) {
    MapPoint at{};
    at[tube.axis] = parameter;
    for (std::size_t i = 0; i < 2; ++i)
      at[tube.others[i]] = tube.cross.center(i) + tube.slope[i] * (parameter - tube.middle);
    return at;
  }

  SliceFamily& family_;
  Interval range_;
  std::vector<CurvePiece> pieces_;
};

Interval hull_of(const Interval& a, const Interval& b) noexcept {
  return {std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}

/// Pieces in turn of one state, which is known.
struct Stretch {
  CurvePiece first, last;
  std::vector<CurvePoint> points{};
  double longest = 0.0;  // of its pieces with a point

  bool is_inside() const noexcept { return first.place == PiecePlace::inside; }
  void add(const CurvePiece& piece) {
    last = piece;
    if (!piece.point) return;
    if (!points.empty() && longest < shortest_with_point) points.clear();
    if (points.empty() || piece.length >= shortest_with_point)
      points.push_back({*piece.point, piece.held_sign});
    longest = std::max(longest, piece.length);
  }
};

/// Known stretches, and what is not known between them.
class RunAssembly {
 public:
  RunAssembly(std::vector<CurvePiece> pieces, const CuspTrace& trace, const Interval& range)
      : closed_(trace.closed), range_(range) {
    if (closed_) rotate(pieces);
    for (const CurvePiece& piece : pieces) add(piece);
    take_ends(trace);
  }

  CurveRuns runs() {
    for (std::size_t j = 0; j < seams_.size(); ++j) {
      if (seams_[j]) take(j, event(j));
      if (j < known_.size() && known_[j].is_inside()) append(known_[j]);
    }
    if (run_) end_run();
    return std::move(result_);
  }

 private:
  /// A closed curve begins outside, or else with a stretch.
  static void rotate(std::vector<CurvePiece>& pieces) {
    const std::size_t count = pieces.size();
    std::optional<std::size_t> start;
    for (std::size_t i = 0; i < count; ++i) {
      const CurvePiece &piece = pieces[i], &before = pieces[(i + count - 1) % count];
      if (piece.place == PiecePlace::unknown || same_state(piece, before)) continue;
      if (!start || piece.place == PiecePlace::outside) start = i;
    }
    if (start)
      std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(*start), pieces.end());
  }

  void add(const CurvePiece& piece) {
    std::optional<Interval>& seam = seams_.back();
    if (piece.place == PiecePlace::unknown) {
      seam = seam ? hull_of(*seam, piece.held) : piece.held;
      return;
    }
    if (!known_.empty() && !seam && same_state(known_.back().last, piece)) {
      known_.back().add(piece);
      return;
    }
    if (!known_.empty() && !seam) seam = intersection(known_.back().last.held, piece.held);
    known_.push_back({piece, piece});
    known_.back().add(piece);
    seams_.emplace_back();
  }

  /// Where a stretch that is inside has no end, the trace has failed.
  void take_ends(const CuspTrace& trace) {
    if (known_.empty()) return;
    if (closed_) {
      if (!seams_.back() && !same_state(known_.back().last, known_.front().first))
        seams_.back() = intersection(known_.back().last.held, known_.front().first.held);
      return;
    }
    const auto held = [](const Box& point) { return Interval(point.lower[2], point.upper[2]); };
    if (!seams_.front() && known_.front().is_inside()) seams_.front() = held(trace.points.front());
    if (!seams_.back() && known_.back().is_inside()) seams_.back() = held(trace.points.back());
  }

  const Stretch* before(std::size_t seam) const {
    if (seam > 0) return &known_[seam - 1];
    return nullptr;
  }

  const Stretch* after(std::size_t seam) const {
    if (seam < known_.size()) return &known_[seam];
    return closed_ && !known_.empty() ? &known_.front() : nullptr;
  }

  CuspEvent event(std::size_t seam) const {
    const Interval& held = *seams_[seam];
    const Interval values = pi_enclosure() * held;
    CuspEvent result{CuspEventKind::unknown, values.lower(), values.upper()};
    const Stretch *a = before(seam), *b = after(seam);
    if (a == nullptr || b == nullptr) return result;
    const CurvePiece &last = a->last, &first = b->first;
    const auto holds = [&](double end) { return held.lower() <= end && end <= held.upper(); };
    if (a->is_inside() != b->is_inside())
      result.kind =
          holds(range_.lower()) || holds(range_.upper()) ? CuspEventKind::range_end : CuspEventKind::limit;
    else if (a->is_inside() && last.held_sign == first.held_sign && last.direction != first.direction)
      result.kind = CuspEventKind::turn;
    else if (a->is_inside() && last.held_sign != first.held_sign && last.direction == first.direction)
      result.kind = CuspEventKind::serial;
    return result;
  }

  void take(std::size_t seam, const CuspEvent& event) {
    const Stretch *a = before(seam), *b = after(seam);
    const bool ends = a != nullptr && a->is_inside(), begins = b != nullptr && b->is_inside();
    if (!ends && !begins) result_.touches.push_back(event);
    if (begins && !run_ && seam < known_.size()) run_.emplace();
    if (run_) run_->events.push_back(event);
    if (run_ && ends && !begins) end_run();
  }

  void append(const Stretch& stretch) {
    if (!run_) run_.emplace();
    run_->points.insert(run_->points.end(), stretch.points.begin(), stretch.points.end());
  }

  void end_run() {
    run_->closed = closed_ && std::all_of(known_.begin(), known_.end(),
                                          [](const Stretch& each) { return each.is_inside(); });
    result_.runs.push_back(std::move(*run_));
    run_.reset();
  }

  bool closed_;
  Interval range_;
  std::vector<Stretch> known_;
  // Seam j is before stretch j; of a closed curve the last one is before the first stretch.
  std::vector<std::optional<Interval>> seams_ = std::vector<std::optional<Interval>>(1);
  std::optional<CurveRun> run_;
  CurveRuns result_;
};

}  // namespace

CurveRuns runs_of(SliceFamily& family, const CuspTrace& trace, const Interval& range,
                  const MapControl& control) {
  const auto pieces = CurveDivision(family, range).pieces_of(trace, control);
  if (is_cancelled(control)) return {};
  return RunAssembly(pieces, trace, range).runs();
}

}  // namespace parallel_aspects
