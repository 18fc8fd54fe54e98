#include "io/geo_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "io/disk_file.hpp"

namespace ixos {
namespace {

using Path = std::filesystem::path;

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& all, std::string_view word) {
  return std::find(all.begin(), all.end(), word) != all.end();
}

/// Words that start programs, or that make commands and options of texts.
constexpr std::array<std::string_view, 10> starting{
    "SystemCall",      "NonBlockingSystemCall", "System",       "OnelabRun", "Solver",
    "ExternalProcess", "CommandLine",           "StringToName", "S2N",       "SetString"};
constexpr std::array<std::string_view, 6> writing{"Save",   "Print",      "CreateDir",
                                                  "Plugin", "OutputFile", "MatlabOutputFile"};
/// Lists of options, and those of the first that are harmless.
constexpr std::array<std::string_view, 4> options{"General", "PostProcessing", "View", "Onelab"};
constexpr std::array<std::string_view, 4> harmless_options{"Terminal", "Verbosity", "NumThreads", "ExpertMode"};
constexpr std::array<std::string_view, 3> printing{"Printf", "Error", "Warning"};
constexpr std::array<std::string_view, 4> naming{"Include", "Merge", "MergeWithBoundingBox", "ShapeFromFile"};
/// Words after which gmsh reads parts of a file again from the beginning of a line, or skips them without regard to
/// texts: what stands in a comment or a text may become a command.
constexpr std::array<std::string_view, 4> branching{"If", "For", "Macro", "Function"};
/// The endings, as gmsh spells them, of files that it reads as shapes whatever they hold. Others it may execute.
constexpr std::array<std::string_view, 12> shapes{".step", ".STEP", ".stp", ".STP", ".brep", ".BREP",
                                                  ".iges", ".IGES", ".igs", ".IGS", ".stl",  ".STL"};

/// gmsh cuts longer texts.
constexpr std::size_t longest_text = 1000;

/// Reads words, texts with their quotes, and signs, without comments.
class Tokens {
 public:
  /// `refuse`: called with what is wrong with the text.
  Tokens(std::string_view text, std::function<void(const std::string&)> refuse)
      : text_(text), refuse_(std::move(refuse)) {}

  /// Returns the next one; "" at the end.
  std::string_view next() {
    skip();
    if (place_ >= text_.size()) return {};
    const std::size_t begin = place_++;
    const char first = text_[begin];
    if (first == '"' || first == '\'') {
      while (place_ < text_.size() && text_[place_] != first && text_[place_] != '\n') ++place_;
      if (place_ >= text_.size() || text_[place_] != first) refuse_("a text does not end in its line");
      if (place_ - begin > longest_text) refuse_("a text is longer than 1000 characters");
      place_ = std::min(place_ + 1, text_.size());
    } else if (is_letter(first)) {
      while (place_ < text_.size() && (is_letter(text_[place_]) || is_digit(text_[place_]))) ++place_;
    } else if (first == '\0') {
      refuse_("the file has a zero byte");
    }
    return text_.substr(begin, place_ - begin);
  }
  std::ptrdiff_t line() const {
    return 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(place_), '\n');
  }

 private:
  static bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  /// Skips white space and comments.
  void skip() {
    while (place_ < text_.size()) {
      const std::string_view here = text_.substr(place_, 2);
      std::size_t end = place_ + 1;
      if (here == "//") {
        end = text_.find('\n', place_);
      } else if (here == "/*") {
        end = text_.find("*/", place_ + 2);
        if (end != std::string_view::npos) end += 2;
      } else if (std::isspace(static_cast<unsigned char>(text_[place_])) == 0) {
        return;
      }
      end = std::min(end, text_.size());
      if (text_.substr(place_, end - place_).find('\0') != std::string_view::npos) refuse_("the file has a zero byte");
      place_ = end;
    }
  }

  std::string_view text_;
  std::function<void(const std::string&)> refuse_;
  std::size_t place_ = 0;
};

/// Returns a script without the signs that begin and end texts and comments.
std::string bared(std::string text) {
  for (const std::string_view sign : {"/*", "*/", "//", "\"", "'"})
    for (std::size_t place = text.find(sign); place != std::string::npos; place = text.find(sign, place))
      text.replace(place, sign.size(), sign.size(), ' ');
  return text;
}

/// The files of a drawing as they are found.
class Scan {
 public:
  explicit Scan(bool trusted) : trusted_(trusted) {}

  bool trusted() const { return trusted_; }
  const std::vector<std::string>& files() const { return files_; }

  /// Adds a file, if it is there, and the options beside it. Checks a script, once: another script may have named the
  /// file in a text before it includes it.
  void add(const std::string& path, bool is_script);

 private:
  bool trusted_;
  std::vector<std::string> files_, scripts_;
};

class Script {
 public:
  Script(std::string path, Scan& scan)
      : path_(std::move(path)),
        scan_(scan),
        text_(read_whole_file(path_)),
        tokens_(text_, [this](const std::string& what) { refuse(what); }) {}

  void read() {
    for (std::string_view token = tokens_.next(); !token.empty();) token = checked(token);
    check_bared();
  }

 private:
  /// Returns whether a word before that token may do something.
  static bool is_command(std::string_view word, std::string_view following) {
    return is_one_of(starting, word) || is_one_of(writing, word) || is_one_of(naming, word) ||
           is_one_of(printing, word) || (is_one_of(options, word) && following == ".");
  }

  /// If the script branches, all its commands must stand outside of texts and comments.
  void check_bared() {
    const std::string bare = bared(text_);
    std::map<std::string_view, int> hidden;
    bool branches = false;
    Tokens tokens(bare, [](const std::string&) {});
    std::string_view token = tokens.next();
    for (std::string_view next; !token.empty(); token = next) {
      next = tokens.next();
      branches = branches || is_one_of(branching, token);
      if (is_command(token, next)) ++hidden[token];
    }
    for (const auto& [word, count] : hidden)
      if (branches && count > seen_[std::string(word)])
        refuse(fmt::format("\"{}\" stands in a comment or a text, which gmsh may execute because of If, For or Macro",
                           word));
  }

  /// Checks a token. Returns the next one.
  std::string_view checked(std::string_view token) {
    if (is_one_of(starting, token)) refuse(fmt::format("\"{}\" starts a program", token));
    if (is_one_of(writing, token)) refuse(fmt::format("\"{}\" writes a file", token));
    if (token.front() == '"' || token.front() == '\'') scan_.add(file_of(token), false);
    const std::string_view following = tokens_.next();
    if (is_command(token, following)) ++seen_[std::string(token)];
    if (is_one_of(options, token)) return option(token, following);
    if (is_one_of(naming, token)) return named(token, following);
    if (is_one_of(printing, token)) {
      depth_ = 0;
      is_printing_ = true;
    }
    if (is_printing_ && token == "(") ++depth_;
    if (is_printing_ && token == ")" && --depth_ == 0) {
      is_printing_ = false;
      if (following == ">") refuse("\"Printf(...) >\" writes a file");
    }
    return following;
  }

  std::string_view option(std::string_view list, std::string_view following) {
    const std::string_view name = following == "." ? tokens_.next() : std::string_view();
    if (list != "General" || !is_one_of(harmless_options, name)) refuse(fmt::format("\"{}\" sets options", list));
    return tokens_.next();
  }

  std::string_view named(std::string_view command, std::string_view name) {
    const char* const after = command.data() + command.size();
    const bool is_text = name.size() > 2 && name.front() == '"' &&
                         std::all_of(after, name.data(), [](unsigned char c) { return std::isspace(c) != 0; });
    const std::string_view end = tokens_.next();
    if (!is_text || end != ";") {
      refuse(fmt::format("\"{}\" does not name its file by a text", command));
      return end;
    }
    const std::string file = file_of(name);
    const std::string ending = Path(file).extension().string();
    const bool is_script = command == "Include" || ending == ".geo";
    if (!is_script && !is_one_of(shapes, ending)) refuse(fmt::format("\"{} {}\" may execute the file", command, name));
    scan_.add(file, is_script);
    return tokens_.next();
  }

  /// Returns the path that a text with quotes would name.
  std::string file_of(std::string_view text) const {
    return (Path(path_).parent_path() / Path(std::string(text.substr(1, text.size() < 2 ? 0 : text.size() - 2))))
        .string();
  }

  void refuse(const std::string& what) const {
    if (scan_.trusted()) return;
    throw InputError(fmt::format(
        "{}: line {}: {}, which a drawing has no need of; if you know the file, allow it with --trust-geometry", path_,
        tokens_.line(), what));
  }

  std::string path_;
  Scan& scan_;
  std::string text_;
  Tokens tokens_;
  std::map<std::string, int> seen_;  ///< by command: how often it stands outside of texts and comments
  bool is_printing_ = false;
  int depth_ = 0;  ///< of parentheses, of what it prints
};

void Scan::add(const std::string& path, bool is_script) {
  if (!is_file(path)) return;
  std::error_code error;
  const Path whole = std::filesystem::weakly_canonical(path, error);  // a script may include itself by many names
  const std::string file = error ? path : whole.string();
  const auto is_new = [&file](std::vector<std::string>& all) {
    if (std::find(all.begin(), all.end(), file) != all.end()) return false;
    all.push_back(file);
    return true;
  };
  if (is_new(files_)) add(file + ".opt", true);
  if (is_script && is_new(scripts_)) Script(file, *this).read();
}

}  // namespace

std::vector<std::string> drawing_files(const std::string& path, bool trusted) {
  if (!is_file(path)) throw FileError(path + ": cannot be read");
  Scan scan(trusted);
  scan.add(path, !is_one_of(shapes, Path(path).extension().string()));
  return scan.files();
}

bool has_word(const std::vector<std::string>& files, const std::string& word) {
  return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
    if (Path(file).extension() != ".geo") return false;
    const std::string text = read_whole_file(file);
    Tokens tokens(text, [](const std::string&) {});
    for (std::string_view token = tokens.next(); !token.empty(); token = tokens.next())
      if (token == word) return true;
    return false;
  });
}

}  // namespace ixos
