#include "base/printable.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace ixos {
namespace {

constexpr std::size_t longest = 4000, beginning = 3000, end = 500;

unsigned byte_at(const std::string& text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
}

/// Returns the number of bytes of the well-formed character that begins at i; 0 if there is none.
std::size_t character(const std::string& text, std::size_t i) {
  const unsigned lead = byte_at(text, i);
  if (lead < 0x80) return 1;
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  for (std::size_t k = 1; k < bytes; ++k)
    if ((byte_at(text, i + k) & 0xc0U) != 0x80) return 0;
  // Refuses characters longer than necessary, surrogates, and numbers beyond U+10FFFF.
  const unsigned second = byte_at(text, i + 1);
  const bool allowed = (lead != 0xe0 || second >= 0xa0) && (lead != 0xed || second < 0xa0) &&
                       (lead != 0xf0 || second >= 0x90) && (lead != 0xf4 || second < 0x90);
  return allowed ? bytes : 0;
}

/// Returns whether the character is one of C0, delete, or C1 (U+0080 to U+009F).
bool controls(const std::string& text, std::size_t i) {
  const unsigned c = byte_at(text, i);
  if (c == 0xc2) return byte_at(text, i + 1) < 0xa0;
  return c < 0x20 || c == 0x7f;
}

}  // namespace

std::string printable(const std::string& text) {
  if (text.size() > longest)
    return printable(text.substr(0, beginning)) + " [...] " + printable(text.substr(text.size() - end));
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t bytes = character(text, i);
    if (bytes == 0 || (controls(text, i) && text[i] != '\t' && text[i] != '\n')) {
      result += fmt::format("\\x{:02x}", byte_at(text, i));
      ++i;
    } else {
      result += text.substr(i, bytes);
      i += bytes;
    }
  }
  return result;
}

std::string::size_type first_unfit_byte(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t bytes = character(text, i);
    if (bytes == 0 || controls(text, i)) return i;
    i += bytes;
  }
  return std::string::npos;
}

}  // namespace ixos
