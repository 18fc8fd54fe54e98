/// Text of files and command lines, made fit for a terminal.
#pragma once
#include <string>

namespace ixos {

/// The text with control characters, but for tabs and line ends, spelt as \x1b: whatever a file says, it moves no
/// cursor and sets no title. Of a text longer than 4000 bytes the middle is left out.
std::string printable(const std::string& text);

/// The first byte of a text that is not UTF-8 (RFC 3629) or a control character, tabs and line ends included;
/// std::string::npos where there is none.
std::string::size_type first_unfit_byte(const std::string& text);

}  // namespace ixos
