/// Catalogues: the things of one kind that a scene chooses by name.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "parameters/one_of.hpp"
#include "parameters/options.hpp"
#include "parameters/scene_node.hpp"
#include "parameters/settings.hpp"
#include "parameters/validation.hpp"

namespace ixos {

/// One thing that a scene may choose: its name in XML, what it is, where it comes from, its parameters with defaults,
/// ranges and documentation, and the function that makes it. The validation, the documentation and the driver's lists
/// are made from this.
template <class Product, class... Context>
struct CatalogueEntry {
  std::string name;
  std::string sentence;  ///< what it is, for documentation; ends with a full stop
  std::string source;    ///< of its formulas: author, year, equation; empty if it has none
  Teuchos::ParameterList parameters;
  /// Makes the thing from its parameters. Throws InputError. Its message need not begin with the path of the list:
  /// Catalogue::make() puts the path there.
  std::function<Product(const SceneNode&, Context...)> make;
  /// Whether its parameters stand in the list that chooses it. Those of other entries stand in a sublist of the entry's
  /// name.
  bool in_place = false;
};

/// An entry as a catalogue declares it.
struct DeclaredEntry {
  std::string name;
  std::string documentation;
  const Teuchos::ParameterList* parameters;
  bool in_place;

  bool has_sublist() const { return !in_place && parameters->numParams() > 0; }
};

/// Throws std::logic_error if two entries have one name, if two entries declare one parameter in place with another
/// type, default, range or documentation, or if such a parameter has the name of the choice or of a sublist.
void check_declared(const std::string& choice, const std::vector<DeclaredEntry>& entries);

/// Adds the choice and the parameters of all entries to a valid list. Throws std::logic_error if the list has an entry
/// of one of these names.
void declare_choice(Teuchos::ParameterList& list, const std::string& choice, const std::string& documentation,
                    const std::vector<DeclaredEntry>& entries);

/// The entries of one kind. `choice` is the name of the parameter that chooses, "Law" or "Type".
template <class Entry>
class Catalogue {
 public:
  /// `documentation`: of the choice; the sentences of entries without a sublist follow it. The first entry is the
  /// default. Throws std::logic_error, see check_declared().
  Catalogue(std::string choice, std::string documentation, std::vector<Entry> entries)
      : choice_(std::move(choice)), documentation_(std::move(documentation)), entries_(std::move(entries)) {
    check_declared(choice_, declared());
  }

  const std::string& choice() const { return choice_; }
  const std::vector<Entry>& entries() const { return entries_; }

  /// Adds the choice and the parameters of all entries to a valid list. Throws std::logic_error, see declare_choice().
  void declare(Teuchos::ParameterList& list) const { declare_choice(list, choice_, documentation_, declared()); }

  /// Returns the entry that a list of a validated scene chooses.
  const Entry& chosen(const SceneNode& node) const {
    const std::string& name = node.text(choice_);
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
    if (found == entries_.end()) throw std::logic_error("the validation let \"" + name + "\" pass");
    return *found;
  }

  /// Makes the chosen thing. Throws InputError whose message begins with the path of the list that has the entry's
  /// parameters.
  template <class... Context>
  auto make(const SceneNode& node, Context&&... context) const {
    const Entry& entry = chosen(node);
    const SceneNode own = declared(entry).has_sublist() ? node.sublist(entry.name) : node;
    return at(own.path(), [&] { return entry.make(own, std::forward<Context>(context)...); });
  }

  /// Makes the thing of that name for a program, whose settings are checked as those of a scene are. `kind`: "elastic
  /// law". Throws InputError that begins with the kind and the name.
  template <class... Context>
  auto make_named(const std::string& kind, const std::string& name, const Settings& settings,
                  Context&&... context) const {
    return at(kind + " \"" + name + "\"", [&] {
      Teuchos::ParameterList valid, given;
      declare(valid);
      given.set(choice_, name);
      const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
      if (found != entries_.end()) set(declared(*found).has_sublist() ? given.sublist(name) : given, settings);
      const Teuchos::ParameterList complete = validated(given, valid);
      return make(SceneNode(complete, ""), std::forward<Context>(context)...);
    });
  }

 private:
  static DeclaredEntry declared(const Entry& entry) {
    std::string text = entry.sentence;
    if (!entry.source.empty()) text = text.substr(0, text.size() - 1) + " (" + entry.source + ").";
    return {entry.name, text, &entry.parameters, entry.in_place};
  }
  std::vector<DeclaredEntry> declared() const {
    std::vector<DeclaredEntry> result;
    for (const Entry& entry : entries_) result.push_back(declared(entry));
    return result;
  }

  std::string choice_;
  std::string documentation_;
  std::vector<Entry> entries_;
};

}  // namespace ixos
