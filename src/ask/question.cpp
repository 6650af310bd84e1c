// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/question.h"

#include <cstddef>
#include <utility>

namespace parallel_aspects::ask {

std::string plain_name(const std::string& field) { return field; }

std::string with_names(const std::string& text, const FieldName& name) {
  std::string result;
  for (std::size_t next = 0; next < text.size();) {
    const std::size_t close = text.find('}', next);
    if (text.compare(next, 2, "{{") == 0) {
      result += '{';
      next += 2;
    } else if (text[next] == '{' && close != std::string::npos) {
      result += name(text.substr(next + 1, close - next - 1));
      next = close + 1;
    } else {
      result += text[next++];
    }
  }
  return result;
}

std::string given(const std::string& text) {
  std::string result;
  for (const char each : text) result += each == '{' ? "{{" : std::string(1, each);
  return result;
}

std::string text_of(const Problem& problem, const FieldName& name) {
  if (problem.kind == ProblemKind::told) return problem.fault;
  if (problem.remedy.empty()) return with_names(problem.fault, name);
  return with_names(problem.fault + "; " + problem.remedy + ".", name);
}

Problems texts_of(const ProblemList& problems, const FieldName& name) {
  Problems texts;
  for (const Problem& problem : problems) texts.push_back(text_of(problem, name));
  return texts;
}

void add_told(const Problems& sentences, ProblemList& problems) {
  for (const std::string& each : sentences) problems.push_back(told(each));
}

Problem told(std::string sentence) { return {ProblemKind::told, {}, std::move(sentence), {}}; }

}  // namespace parallel_aspects::ask
