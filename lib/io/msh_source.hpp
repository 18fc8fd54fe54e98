/// The bytes of a .msh file, read section by section.
#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace ixos {

/// Reads numbers of a file of gmsh's formats MSH 4.1 and 2.2, in ASCII or binary. Lines may end as on Windows, numbers
/// may have a plus sign. Trusts nothing: whatever is not as the format demands ends in an InputError that names the
/// file, the line (ASCII) or byte (binary) and what was found.
class MshSource {
 public:
  /// Reads the whole file. Throws InputError if it is no readable file.
  explicit MshSource(const std::string& path);
  /// Reads bytes that are in memory; messages name `path`. Skips the byte-order mark of UTF-8.
  MshSource(std::string path, std::string bytes);

  std::size_t length() const { return bytes_.size(); }  ///< of the file [bytes]

  /// Lets the numbers of later sections be binary, or text.
  void set_binary(bool binary) { binary_ = binary; }

  /// Goes to the next section, and returns its name without "$"; empty at the end of the file. The previous section
  /// must have ended.
  std::string next_section();
  /// Goes to the end of the section. Throws if the section holds anything else before its end.
  void end_section();
  /// Goes behind the end of the section, whatever it holds.
  void skip_section();

  /// Returns the rest of the line, which is text in binary files too, and goes to the next line.
  std::string_view line();
  /// Returns the next word, which is text in binary files too. `what` names it in messages.
  std::string_view word(const char* what);

  std::int64_t integer(const char* what);  ///< an int of the format
  std::uint64_t size(const char* what);    ///< a size_t of the format
  double number(const char* what);         ///< finite

  /// The least numbers of values in each entry of a list.
  struct Entry {
    std::size_t integers = 0, sizes = 0, numbers = 0;
  };
  /// Returns a size that counts entries of a list. Throws if the rest of the file cannot hold them: so the caller may
  /// reserve memory for them.
  std::size_t count(const char* what, const Entry& entry);

  /// Throws InputError with the file and the place before the message.
  template <class... Values>
  [[noreturn]] void refuse(fmt::format_string<Values...> text, Values&&... values) const {
    refuse_here(fmt::format(text, std::forward<Values>(values)...));
  }
  /// Throws InputError with the file before the message.
  template <class... Values>
  [[noreturn]] void refuse_file(fmt::format_string<Values...> text, Values&&... values) const {
    refuse_whole(fmt::format(text, std::forward<Values>(values)...));
  }

 private:
  [[noreturn]] void refuse_here(const std::string& why) const;
  [[noreturn]] void refuse_whole(const std::string& why) const;
  [[noreturn]] void refuse_end() const;
  void skip_blanks();
  template <class T>
  T raw();
  template <class T>
  T parsed(const char* what, const char* kind);

  std::string path_;
  std::string bytes_;
  std::string section_;     ///< the current one
  std::size_t place_ = 0;   ///< of the next byte
  std::size_t before_ = 0;  ///< where the last word or number began: a message names this place
  bool binary_ = false;
};

}  // namespace ixos
