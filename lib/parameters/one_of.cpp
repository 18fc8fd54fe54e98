#include "parameters/one_of.hpp"

#include <Teuchos_StandardParameterEntryValidators.hpp>
#include <algorithm>

namespace ixos {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Teuchos::Array<std::string> names_of(const std::vector<Choice::Word>& words) {
  Teuchos::Array<std::string> names;
  for (const Choice::Word& word : words) names.push_back(word.name);
  return names;
}

class ChoiceValidator final : public Teuchos::StringValidator {
 public:
  explicit ChoiceValidator(const Choice& choice) : StringValidator(names_of(choice.words)), choice_(choice) {}
  const Choice& choice() const { return choice_; }

 private:
  Choice choice_;
};

}  // namespace

std::vector<std::string> Choice::belongings(const std::string& word) const {
  for (const Word& candidate : words)
    if (candidate.name == word) return candidate.belongings;
  return {};
}

std::vector<std::string> Choice::left_out(const std::string& word) const {
  std::vector<std::string> result;
  if (std::none_of(words.begin(), words.end(), [&](const Word& w) { return w.name == word; })) return result;
  const std::vector<std::string> own = belongings(word);
  for (const Word& other : words)
    for (const std::string& name : other.belongings)
      if (!contains(own, name) && !contains(result, name)) result.push_back(name);
  return result;
}

std::vector<std::string> Choice::owners(const std::string& name) const {
  std::vector<std::string> result;
  for (const Word& word : words)
    if (contains(word.belongings, name)) result.push_back(word.name);
  return result;
}

Teuchos::RCP<const Teuchos::ParameterEntryValidator> one_of(const std::vector<std::string>& words) {
  return Teuchos::rcp(new Teuchos::StringValidator(Teuchos::Array<std::string>(words)));
}

Teuchos::RCP<const Teuchos::ParameterEntryValidator> choice_of(const std::vector<std::string>& words) {
  Choice choice;
  for (const std::string& word : words) choice.words.push_back({word, {word}});
  return Teuchos::rcp(new ChoiceValidator(choice));
}

Teuchos::RCP<const Teuchos::ParameterEntryValidator> exclusive_choice_of(const std::vector<Choice::Word>& words) {
  return Teuchos::rcp(new ChoiceValidator({words, true}));
}

const Choice* choice_behind(const Teuchos::RCP<const Teuchos::ParameterEntryValidator>& validator) {
  const auto* found = dynamic_cast<const ChoiceValidator*>(validator.get());
  return found == nullptr ? nullptr : &found->choice();
}

}  // namespace ixos
