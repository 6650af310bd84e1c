// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/question.h"

#include <cstddef>
#include <utility>

namespace parallel_aspects::ask {

std::string plain_name(const std::string& field) { return field; }

std::string with_names(const std::string& text, const FieldName& name) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', done)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) break;
    result += text.substr(done, open - done) + name(text.substr(open + 1, close - open - 1));
    done = close + 1;
  }
  return result + text.substr(done);
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

Problem told(std::string sentence) { return {ProblemKind::told, {}, std::move(sentence), {}}; }

}  // namespace parallel_aspects::ask
