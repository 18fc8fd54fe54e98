/// Text from files and command lines, made safe for a terminal.
#pragma once
#include <string>

namespace ixos {

/// Returns the text with control characters (except tabs and line ends) spelt as \x1b: no content of a file can move
/// the cursor or set the title. Omits the middle of a text longer than 4000 bytes.
std::string printable(const std::string& text);

/// Returns the position of the first byte that is not UTF-8 (RFC 3629) or is a control character, tabs and line ends
/// included; returns std::string::npos if there is none.
std::string::size_type first_unfit_byte(const std::string& text);

}  // namespace ixos
