#include "completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "shell_word.hpp"

namespace ixos {
namespace {

/// The functions of the script. @program@ and @function@ stand for the name of the program, as a command and as a part
/// of names in bash; @cases@ for the options with values.
const char* const functions = R"bash(
# Prints what the beginning $1 of a setting can go on with, up to the next "/" or "=".
_@function@_settings() {
  local start=$1 line rest before name
  local -A found=()
  while IFS= read -r line; do
    while [[ $line == *'<any name>'* ]]; do  # takes the name that stands there
      before=${line%%'<any name>'*}
      rest=${start#"$before"}
      if [[ $start != "$before"* || $rest != */* ]]; then break; fi
      name=${rest%%/*}
      line=$before$name${line#*'<any name>'}
    done
    line=${line%%'<any name>'*}
    if [[ $line == "$start" && $start == */ ]]; then found[$start'<name>']=1; fi
    if [[ -z $line || $line != "$start"* || $line == "$start" ]]; then continue; fi
    rest=${line#"$start"}
    case $rest in
      */*) rest=${rest%%/*}/ ;;
      *=*) rest=${rest%%=*}= ;;
    esac
    found[$start$rest]=1
  done <<<"$_@function@_lines"
  if ((${#found[@]})); then printf '%s\n' "${!found[@]}"; fi
}

_@function@() {
  local word=${COMP_WORDS[COMP_CWORD]} last=$((COMP_CWORD - 1)) joined="" quote="" option i
  # bash separates words at "=" outside quotes, in "--set=..." and in settings.
  if [[ $word == = ]]; then word="" last=$COMP_CWORD; fi
  while [[ ${COMP_WORDS[last]} == = ]]; do
    last=$((last - 1))
    if [[ ${COMP_WORDS[last]} == --* ]]; then break; fi
    joined=${COMP_WORDS[last]}=$joined last=$((last - 1))
  done
  option=${COMP_WORDS[last]}
  case $word in [\"\']*) quote=${word:0:1} word=${word:1} ;; esac
  COMPREPLY=()
  if [[ $option == --set ]]; then
    local start=$joined$word candidates=() shown
    if [[ -z $quote ]]; then start=${start//\\/}; fi
    mapfile -t candidates < <(_@function@_settings "$start")
    while ((${#candidates[@]} == 1)) && [[ ${candidates[0]} == */ ]]; do  # the only list: its contents
      start=${candidates[0]}
      mapfile -t candidates < <(_@function@_settings "$start")
    done
    if ((${#candidates[@]} == 1)); then
      case $quote${candidates[0]} in
        # Shows a type, or what single quotes cannot hold, but does not insert it.
        *'>' | "'"*"'"*) candidates+=("$start") ;;
        *=)  # bash closes quotes after a sole word
          mapfile -t shown < <(_@function@_settings "${candidates[0]}")
          candidates+=("${shown[@]}") ;;
      esac
    fi
    for i in "${candidates[@]}"; do
      if [[ -n $joined ]]; then i=${i#*=}; fi
      if [[ -z $quote ]]; then printf -v i '%q' "$i"; fi
      COMPREPLY+=("$i")
    done
    compopt -o nospace
    return
  fi
  case $option in
@cases@  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$_@function@_options" -- "$word")
    return
  fi
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -f -X '!*.xml' -- "$word"; compgen -d -- "$word")
}

complete -F _@function@ @program@
)bash";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (auto place = text.find(what); place != std::string::npos; place = text.find(what, place + by.size()))
    text.replace(place, what.size(), by);
  return text;
}

/// Returns the case of an option that takes a value: one of its words, or a folder or file by the name of its type.
std::string value_case(const CLI::Option& option, const std::string& name,
                       const std::map<std::string, std::vector<std::string>>& words) {
  const auto found = words.find(name);
  const std::string type = option.get_type_name();
  std::string action;
  if (found != words.end())
    action = "compgen -W " + shell_word(fmt::format("{}", fmt::join(found->second, " "))) + " -- \"$word\"";
  else if (type == "FOLDER" || type == "FILE")
    action = std::string("compgen ") + (type == "FILE" ? "-f" : "-d") + " -- \"$word\"";
  else
    return "    " + name + ") return ;;\n";
  return fmt::format("    {}) {}mapfile -t COMPREPLY < <({}); return ;;\n", name,
                     found == words.end() ? "compopt -o filenames; " : "", action);
}

}  // namespace

std::string bash_completion(const CLI::App& app, const std::map<std::string, std::vector<std::string>>& words,
                            const std::vector<std::string>& settings) {
  std::string options, cases;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) {
      options += (options.empty() ? "--" : " --") + name;
      if (option->get_expected_max() > 0) cases += value_case(*option, "--" + name, words);
    }
  }
  const std::string& program = app.get_name();
  const std::string function = replaced(program, "-", "_");
  std::string script = replaced(replaced(functions, "@cases@", cases), "@program@", program);
  script = replaced(script, "@function@", function);
  return fmt::format(
      "# Completes commands of {0} in bash. Made by: {0} --completion\n_{1}_options={2}\n_{1}_lines={3}\n{4}", program,
      function, shell_word(options), shell_word(fmt::format("{}", fmt::join(settings, "\n"))), script);
}

}  // namespace ixos
