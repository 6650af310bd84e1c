// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/batches/lane_examiner.h"

#include "aspects/batches/lane_versions.h"
#include "aspects/batches/part_lanes.h"

namespace parallel_aspects {
namespace {

template <class Chart>
struct ExaminedBoxes {
  const Chart& chart;
  const std::array<int, Chart::leg_count>& signs;
  int sign;
  bool shells;
  const SharedFace* boxes;
  std::size_t count;
  Examined* examined;
};

template <class Numbers, class Chart>
void examine(const ExaminedBoxes<Chart>& of) {
  PartLanes<Chart, Numbers>(of.chart, of.signs, of.sign, of.boxes, of.count).examine(of.shells, of.examined);
}

template <class Chart>
PARALLEL_ASPECTS_FOR_PAIRS void examine_pair(const ExaminedBoxes<Chart>& of) noexcept {
  examine<Lanes<2>>(of);
}

template <class Chart>
PARALLEL_ASPECTS_FOR_FOUR void examine_four(const ExaminedBoxes<Chart>& of) noexcept {
  examine<Lanes<4>>(of);
}

template <class Chart>
PARALLEL_ASPECTS_FOR_EIGHT void examine_eight(const ExaminedBoxes<Chart>& of) noexcept {
  examine<Lanes<8>>(of);
}

template <class Chart>
void examine_all(const Chart& chart, const std::array<int, Chart::leg_count>& signs, int sign, bool shells,
                 const std::vector<SharedFace>& boxes, Examined* examined, InstructionSet instructions) {
  const std::size_t lanes = lanes_of(instructions);
  for_each_group(boxes, lanes, [&](std::size_t first, std::size_t count) {
    const ExaminedBoxes<Chart> of{chart, signs, sign, shells, &boxes[first], count, examined + first};
    if (lanes == 8) return examine_eight(of);
    if (lanes == 4) return examine_four(of);
    examine_pair(of);
  });
}

}  // namespace

void examine_in_lanes(const T2Chart& chart, const std::array<int, T2Chart::leg_count>& signs, int sign,
                      bool shells, const std::vector<SharedFace>& boxes, Examined* examined,
                      InstructionSet instructions) noexcept {
  examine_all(chart, signs, sign, shells, boxes, examined, instructions);
}
void examine_in_lanes(const SE2Chart& chart, const std::array<int, SE2Chart::leg_count>& signs, int sign,
                      bool shells, const std::vector<SharedFace>& boxes, Examined* examined,
                      InstructionSet instructions) noexcept {
  examine_all(chart, signs, sign, shells, boxes, examined, instructions);
}
void examine_in_lanes(const T3Chart& chart, const std::array<int, T3Chart::leg_count>& signs, int sign,
                      bool shells, const std::vector<SharedFace>& boxes, Examined* examined,
                      InstructionSet instructions) noexcept {
  examine_all(chart, signs, sign, shells, boxes, examined, instructions);
}

}  // namespace parallel_aspects
