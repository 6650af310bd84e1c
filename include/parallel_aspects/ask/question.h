// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_QUESTION_H
#define PARALLEL_ASPECTS_ASK_QUESTION_H

#include "parallel_aspects/model/problems.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// A question and an answer are structs, each with one list of its fields, a function
//
//   template <class Visit> void describe(Visit& visit, PlanQuestion& question) {
//     visit({"policy", "stay|serial|any", "What the path may pass"}, question.policy);
//     ...
//   }
//
// Every face stands on these lists: options and their help, JSON, keywords and results of Python, and the
// tables of the documentation come from them. A face is a `visit`, which has an operator() for each type that
// a field may have, and knows nothing else of it.
namespace parallel_aspects::ask {

/// What all faces say of a field.
struct Field {
  std::string name;   ///< lower case, words joined by "_", as Python and messages write it
  std::string value;  ///< of a question: what stands for a value in the help, as "N"; of an answer: its unit
  std::string help;   ///< what it is; no full stop at the end
};

/// A whole number within this range.
template <unsigned least, unsigned largest>
struct Count {
  unsigned value = least;                     ///< from the first to the second
  static constexpr unsigned upper = largest;  ///< the second
};

/// A value where there is one, else nothing.
template <class Value>
std::optional<Value> only_if(bool holds, const Value& value) {
  return holds ? std::make_optional(value) : std::nullopt;
}

/// One of the legs, which faces write by its name.
struct LegIndex {
  std::size_t index = 0;  ///< in the order of the legs
};

/// The index of that leg, or none.
inline std::optional<LegIndex> leg_or_none(const std::optional<std::size_t>& leg) {
  return leg ? std::make_optional(LegIndex{*leg}) : std::nullopt;
}

/// Numbers by name.
using NamedValues = std::vector<std::pair<std::string, double>>;

/// A range of a coordinate or joint.
struct NamedRange {
  std::string name;    ///< whose
  double lower = 0.0;  ///< [m or rad]
  double upper = 0.0;  ///< [m or rad]
};

/// The value of an enumeration with this name. Nothing where there is none; `names` are then all, as
/// "stay, serial or any". It has `choices` and `name`, found by its namespace.
template <class Choice>
std::optional<Choice> choice_named(const std::string& text, std::string& names) {
  const auto all = choices(Choice{});
  names.clear();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (text == name(all[i])) return all[i];
    names += (i == 0 ? "" : i + 1 == all.size() ? " or " : ", ") + std::string(name(all[i]));
  }
  return std::nullopt;
}

/// The sign of det A.
enum class Sign { plus, minus };
/// All values, for whoever reads one by its name.
inline constexpr std::array<Sign, 2> choices(Sign /*tag*/) { return {Sign::plus, Sign::minus}; }
/// "+" or "-".
inline const char* name(Sign sign) { return sign == Sign::plus ? "+" : "-"; }
/// 1 or -1; 0 for none.
inline int value_of(const std::optional<Sign>& sign) { return !sign ? 0 : *sign == Sign::plus ? 1 : -1; }

/// What is wrong with a question.
enum class ProblemKind {
  missing,   ///< a field that is needed is not given
  value,     ///< of one field
  together,  ///< fields that exclude each other, or of which one needs another
  robot,     ///< the robot has no answer of this kind
  told,      ///< a sentence of a layer below, which names no field
};

/// Why a question is refused. Fields stand in braces, as "{policy} any needs a map", where a face writes the
/// value in its own way, too, with it, as "{start_sign +}": each face writes them in its own way, as the last
/// step, and nobody reads the text.
struct Problem {
  ProblemKind kind = ProblemKind::told;  ///< see there
  std::string field;                     ///< at fault; empty where it is no single one
  std::string fault;                     ///< a clause; where there is no remedy, whole sentences
  std::string remedy;                    ///< "give {policy} serial": what follows the semicolon
};

using ProblemList = std::vector<Problem>;  ///< all of them, not just the first

/// How a face writes a field: "around_cusp" as "--around-cusp".
using FieldName = std::function<std::string(const std::string& field)>;

/// As Python and messages write it: as it is.
std::string plain_name(const std::string& field);

/// The text with its fields written so.
std::string with_names(const std::string& text, const FieldName& name);

/// "FAULT; REMEDY."
std::string text_of(const Problem& problem, const FieldName& name);
Problems texts_of(const ProblemList& problems, const FieldName& name);  ///< of each

/// A name or text of the user's, as part of a text with fields in braces: its own braces stay as they are.
std::string given(const std::string& text);

/// A sentence of a layer below.
Problem told(std::string sentence);
void add_told(const Problems& sentences, ProblemList& problems);  ///< each of several

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_QUESTION_H
