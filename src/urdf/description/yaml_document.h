// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_YAML_DOCUMENT_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_YAML_DOCUMENT_H

#include <string>

namespace YAML {
class Node;
}

namespace parallel_aspects {

/// The only document of a YAML file; null where it is empty. Throws YAML::ParserException where the text is
/// no YAML, holds another document, or, with each alias counted as what it stands for, says more than any
/// robot needs: a few lines of aliases can stand for gigabytes.
YAML::Node yaml_document(const std::string& text);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_YAML_DOCUMENT_H
