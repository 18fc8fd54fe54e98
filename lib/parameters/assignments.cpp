#include "parameters/assignments.hpp"

#include <fmt/format.h>

#include <Teuchos_ParameterEntryValidator.hpp>

#include "parameters/parameter_entries.hpp"
#include "parameters/parameter_text.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

std::vector<std::string> words(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<bool>()) return {"true", "false"};
  if (const auto validator = entry.validator(); !validator.is_null())
    if (const auto choices = validator->validStringValues(); !choices.is_null())
      return {choices->begin(), choices->end()};
  return {'<' + type_name(entry) + '>'};
}

void add(const Teuchos::ParameterList& valid, const std::string& path, std::vector<std::string>& lines) {
  if (is_free_form(valid)) {
    lines.push_back(path);
    return;
  }
  if (is_like_root(valid)) lines.push_back(path);
  for (const auto& [name, entry] : entries(valid)) {
    if (entry.isList()) {
      add(valid.sublist(name), path + name + '/', lines);
      continue;
    }
    for (const std::string& word : words(entry)) lines.push_back(fmt::format("{}{}={}", path, name, word));
  }
}

}  // namespace

std::vector<std::string> assignments(const Teuchos::ParameterList& valid) {
  std::vector<std::string> lines;
  add(valid, "", lines);
  return lines;
}

}  // namespace ixos
