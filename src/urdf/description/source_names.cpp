// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/source_names.h"

#include "urdf/description/command_options.h"

namespace parallel_aspects {

std::string SourceNames::key(const std::string& key) const { return as_options ? option_name(key) : key; }

std::string SourceNames::full_key(const std::string& key) const {
  return as_options ? option_name(key) : "mechanism." + key;
}

std::string SourceNames::entry(const std::string& key, const std::string& value) const {
  return as_options ? option_for(key, {value}) : key + ": " + value;
}

std::string SourceNames::entry(const std::string& key, const std::vector<std::string>& values) const {
  if (as_options) return option_for(key, values);
  std::string list;
  for (const std::string& value : values) list += (list.empty() ? "" : ", ") + value;
  return key + ": [" + list + "]";
}

}  // namespace parallel_aspects
