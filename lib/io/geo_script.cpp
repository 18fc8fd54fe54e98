#include "io/geo_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
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
/// The endings, as gmsh spells them, of files that it reads as shapes whatever they hold. Others it may execute.
constexpr std::array<std::string_view, 12> shapes{".step", ".STEP", ".stp", ".STP", ".brep", ".BREP",
                                                  ".iges", ".IGES", ".igs", ".IGS", ".stl",  ".STL"};

/// gmsh cuts longer texts.
constexpr std::size_t longest_text = 1000;

std::string contents(const std::string& path) {
  std::ifstream stream = open_text(path);
  if (!stream) throw FileError(path + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

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

class Script {
 public:
  Script(std::string path, bool trusted, std::vector<std::string>& files)
      : path_(std::move(path)),
        trusted_(trusted),
        files_(files),
        text_(contents(path_)),
        tokens_(text_, [this](const std::string& what) { refuse(what); }) {}

  void read() {
    for (std::string_view token = tokens_.next(); !token.empty();) token = checked(token);
  }

 private:
  /// Checks a token. Returns the next one.
  std::string_view checked(std::string_view token) {
    if (is_one_of(starting, token)) refuse(fmt::format("\"{}\" starts a program", token));
    if (is_one_of(writing, token)) refuse(fmt::format("\"{}\" writes a file", token));
    if (token.front() == '"' || token.front() == '\'') add(file_of(token));
    const std::string_view following = tokens_.next();
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
    const bool is_text = name.size() > 2 && name.front() == '"';
    const std::string_view end = tokens_.next();
    if (!is_text || end != ";") {
      refuse(fmt::format("\"{}\" does not name its file by a text", command));
      return end;
    }
    const std::string file = file_of(name);
    const std::string ending = Path(file).extension().string();
    const bool is_script = command == "Include" || ending == ".geo";
    if (!is_script && !is_one_of(shapes, ending)) refuse(fmt::format("\"{} {}\" may execute the file", command, name));
    if (add(file) && is_script) Script(file, trusted_, files_).read();
    return tokens_.next();
  }

  /// Returns the path that a text with quotes would name.
  std::string file_of(std::string_view text) const {
    return (Path(path_).parent_path() / Path(std::string(text.substr(1, text.size() < 2 ? 0 : text.size() - 2))))
        .string();
  }

  /// Adds a file, with the options beside it. Returns whether it is there and new.
  bool add(const std::string& file) {
    if (!is_file(file) || std::find(files_.begin(), files_.end(), file) != files_.end()) return false;
    files_.push_back(file);
    add_options(file, trusted_, files_);
    return true;
  }

  void refuse(const std::string& what) const {
    if (trusted_) return;
    throw InputError(fmt::format(
        "{}: line {}: {}, which a drawing has no need of; if you know the file, allow it with --trust-geometry", path_,
        tokens_.line(), what));
  }

  std::string path_;
  bool trusted_;
  std::vector<std::string>& files_;
  std::string text_;
  Tokens tokens_;
  bool is_printing_ = false;
  int depth_ = 0;  ///< of parentheses, of what it prints

 public:
  /// Adds and checks the options that gmsh reads after a file.
  static void add_options(const std::string& file, bool trusted, std::vector<std::string>& files) {
    const std::string own = file + ".opt";
    if (!is_file(own) || std::find(files.begin(), files.end(), own) != files.end()) return;
    files.push_back(own);
    Script(own, trusted, files).read();
  }
};

}  // namespace

std::vector<std::string> drawing_files(const std::string& path, bool trusted) {
  std::vector<std::string> files{path};
  if (!is_file(path)) throw FileError(path + ": cannot be read");
  if (!is_one_of(shapes, Path(path).extension().string())) Script(path, trusted, files).read();
  Script::add_options(path, trusted, files);
  return files;
}

bool has_word(const std::vector<std::string>& files, const std::string& word) {
  return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
    if (Path(file).extension() != ".geo") return false;
    const std::string text = contents(file);
    Tokens tokens(text, [](const std::string&) {});
    for (std::string_view token = tokens.next(); !token.empty(); token = tokens.next())
      if (token == word) return true;
    return false;
  });
}

}  // namespace ixos
