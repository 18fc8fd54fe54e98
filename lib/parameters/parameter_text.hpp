/// Parameter values as text, read strictly.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

namespace ixos {

/// Sets `list`'s entry `name` to the value that `text` spells in the type "double", "int", "bool", "string",
/// "Array(double)", "Array(int)" or "Array(string)". The whole text must be read: "1.5x" is no double, "1e-3" no int.
/// A number with a unit ("2 MPa"), or a list of such numbers ("{1, 2} nm"), is kept as a string: the dimension of the
/// parameter is not known here (see scene/read/scene_units.hpp).
/// Throws InputError with the text and the type, or with the unit if there is no such unit; for an unknown type it
/// names the known types. Throws also for strings that are not UTF-8 or hold control characters, for an array's element
/// that is empty, and for a name that check_name() refuses.
void set_from_text(Teuchos::ParameterList& list, const std::string& name, const std::string& type,
                   const std::string& text);

/// Throws InputError for a name of more than 255 bytes, one that is not UTF-8 or holds control characters, and one in
/// angle brackets, which have a special meaning in lists of valid parameters.
void check_name(const std::string& name);

/// Returns the type's name as it is spelt in XML; "unknown" for any other.
std::string type_name(const Teuchos::ParameterEntry& entry);

/// Returns the value as it would be spelt in XML.
std::string value_text(const Teuchos::ParameterEntry& entry);

/// Returns the value as a person would write it: numbers with no more digits than they need.
std::string short_text(const Teuchos::ParameterEntry& entry);

}  // namespace ixos
