/// Parameter lists from XML.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <cstddef>
#include <string>

namespace ixos {

inline constexpr std::size_t largest_xml = 16U << 20U;  ///< bytes of a file
inline constexpr std::size_t deepest_list = 100;        ///< lists within lists

/// Reads <ParameterList> and <Parameter> as Teuchos writes them, with Expat: Teuchos' own parser takes time with the
/// square of the depth, and a deep list ends in a stack overflow. Ignores <Validators>. `origin` stands for the file in
/// messages. Throws InputError with the line, or the list path, for text that is not well-formed or not UTF-8, other
/// elements, missing attributes, names given twice, values that are not of their type, document types (<!DOCTYPE) and
/// text that is too large or too deep.
Teuchos::ParameterList list_from_xml(const std::string& xml, const std::string& origin);

}  // namespace ixos
