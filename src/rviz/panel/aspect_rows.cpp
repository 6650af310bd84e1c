// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/aspect_rows.h"

#include "model/message_text.h"

#include <parallel_aspects/Status.h>

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int digits_of_measure = 5;  // as `aspects map` prints it

const char* sign_text(int sign) { return sign > 0 ? "> 0" : "< 0"; }

const AspectState* followed(const NodeView& view) {
  const bool known = view.connected && view.state && view.state->status.code == Status::OK;
  return known ? &*view.state : nullptr;
}

ModeRows& rows_of_mode(std::vector<ModeRows>& modes, const std::vector<std::int8_t>& signs,
                       const AspectState* state) {
  const std::string mode = mode_of(signs);
  const auto found =
      std::find_if(modes.begin(), modes.end(), [&](const ModeRows& each) { return each.mode == mode; });
  if (found != modes.end()) return *found;
  modes.push_back({mode, state && state->working_mode == signs, {}});
  return modes.back();
}

std::string tip_of(const AspectSummary& aspect) {
  std::string tip = "Size proved between " + number_text(aspect.measure_lower, digits_of_measure) + " and " +
                    number_text(aspect.measure_upper, digits_of_measure) + " " + aspect.unit +
                    ". Deepest at " + pose_of(aspect.deepest_pose) + ".";
  if (aspect.unresolved_with.empty()) return tip;
  tip += " May be the same aspect as";
  for (const std::uint32_t id : aspect.unresolved_with) tip += " " + std::to_string(id);
  return tip + ".";
}

// So that all columns fit, where the tip has more digits; without an exponent below a million.
std::string short_text(double size) {
  int digits = 3;
  for (double limit = 1e3; digits < 6 && size >= limit; limit *= 10.0) ++digits;
  return number_text(size, digits);
}

AspectRow row_of(const AspectSummary& aspect, const NodeView& view) {
  AspectRow row;
  row.id = aspect.id;
  row.name = std::to_string(aspect.id) + (aspect.unresolved_with.empty() ? "" : " ?");
  row.sign = sign_text(aspect.determinant_sign);
  row.size = short_text(aspect.measure);
  row.clearance = number_text(aspect.deepest_clearance, 2);
  row.tip = tip_of(aspect);
  const AspectState* const state = followed(view);
  row.present = state && state->aspect == aspect.id;
  if (!view.deepest_index) return row;
  const auto index = view.deepest_index->find(aspect.id);
  if (index != view.deepest_index->end()) row.index = number_text(index->second, 2);
  return row;
}

std::vector<Rgb> colors_of(const std::vector<AspectSummary>& summaries) {
  std::vector<Aspect> aspects;
  for (const AspectSummary& each : summaries) {
    Aspect aspect;
    aspect.mode =
        WorkingMode::from_signs({each.working_mode.begin(), each.working_mode.end()}).value_or(aspect.mode);
    aspect.determinant_sign = each.determinant_sign;
    aspects.push_back(aspect);
  }
  return aspect_colors(aspects);
}

void add_components(const RoadmapComponents& components, const AspectState* state, ModeRows& rows) {
  std::size_t number = 0;
  for (const std::uint32_t size : components.component_sizes) {
    AspectRow row;
    row.name = "component " + std::to_string(++number);
    row.sign = sign_text(components.determinant_sign);
    row.size = std::to_string(size) + (size == 1 ? " sample" : " samples");
    row.tip = "Samples of the roadmap that are proved to lie in one aspect.";
    row.present = state && components.component_sizes.size() == 1 && rows.present &&
                  state->determinant_sign == components.determinant_sign;
    rows.aspects.push_back(row);
  }
}

}  // namespace

std::vector<ModeRows> rows_of(const NodeView& view) {
  std::vector<ModeRows> modes;
  if (!view.aspects) return modes;
  const AspectState* const state = followed(view);
  const std::vector<Rgb> colors = colors_of(view.aspects->aspects);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const AspectSummary& aspect = view.aspects->aspects[i];
    AspectRow row = row_of(aspect, view);
    row.color = colors[i];
    rows_of_mode(modes, aspect.working_mode, state).aspects.push_back(std::move(row));
  }
  for (const RoadmapComponents& each : view.aspects->roadmap)
    add_components(each, state, rows_of_mode(modes, each.working_mode, state));
  return modes;
}

std::string unit_of(const NodeView& view) {
  if (!view.aspects || view.aspects->aspects.empty()) return {};
  std::string unit = view.aspects->aspects.front().unit;
  for (const auto& [plain, raised] : {std::pair("^2", "\u00B2"), std::pair("^3", "\u00B3")})
    if (const std::size_t place = unit.find(plain); place != std::string::npos)
      unit.replace(place, 2, raised);
  return unit;
}

std::string count_text(const NodeView& view) {
  if (const Permission asked = may_ask(view); !asked) return asked.refusal;
  if (!view.aspects) return "Waits for the map.";
  const ListAspects::Response& list = *view.aspects;
  if (list.aspects.empty() && list.roadmap.empty())
    return list.status.message.empty() ? "Waits for the map." : list.status.message;
  if (list.aspects.empty())
    return "At least " + std::to_string(list.proved_count) + " aspects, proved by a roadmap.";
  const std::string least = std::to_string(list.proved_count);
  if (list.count_at_most == static_cast<std::int64_t>(list.proved_count))
    return "Exactly " + least + " aspects, proved.";
  return std::to_string(list.aspects.size()) + " aspects found; at least " + least + ", proved.";
}

std::set<std::uint32_t> ids_of(const NodeView& view) {
  std::set<std::uint32_t> ids;
  if (!view.aspects) return ids;
  for (const AspectSummary& aspect : view.aspects->aspects) ids.insert(aspect.id);
  return ids;
}

}  // namespace parallel_aspects
