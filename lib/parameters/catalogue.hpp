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
  /// Makes the thing from its parameters. Throws InputError.
  std::function<Product(const SceneNode&, Context...)> make;
  /// Whether its parameters stand in the list that chooses it. Those of other entries stand in a sublist of the entry's
  /// name.
  bool in_place = false;
};

/// The entries of one kind. `choice` is the name of the parameter that chooses, "Law" or "Type".
template <class Entry>
class Catalogue {
 public:
  /// `documentation`: of the choice; the sentences of entries without a sublist follow it. The first entry is the
  /// default.
  Catalogue(std::string choice, std::string documentation, std::vector<Entry> entries)
      : choice_(std::move(choice)), documentation_(std::move(documentation)), entries_(std::move(entries)) {}

  const std::string& choice() const { return choice_; }
  const std::vector<Entry>& entries() const { return entries_; }

  /// Adds the choice and the parameters of all entries to a valid list.
  void declare(Teuchos::ParameterList& list) const {
    std::vector<std::string> names;
    std::string text = documentation_;
    for (const Entry& entry : entries_) {
      names.push_back(entry.name);
      if (!has_sublist(entry)) text += " " + described(entry);
    }
    list.set(choice_, names.front(), text, choice_of(names));
    for (const Entry& entry : entries_) {
      if (entry.in_place) {
        for (auto it = entry.parameters.begin(); it != entry.parameters.end(); ++it)
          list.setEntry(entry.parameters.name(it), it->second);
        continue;
      }
      if (!has_sublist(entry)) continue;
      list.sublist(entry.name, false, described(entry)) = entry.parameters;
      list.sublist(entry.name).setName(entry.name);
    }
  }

  /// Returns the entry that a list of a validated scene chooses.
  const Entry& chosen(const SceneNode& node) const {
    const std::string& name = node.text(choice_);
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
    if (found == entries_.end()) throw std::logic_error("the validation let \"" + name + "\" pass");
    return *found;
  }

  /// Makes the chosen thing.
  template <class... Context>
  auto make(const SceneNode& node, Context&&... context) const {
    const Entry& entry = chosen(node);
    return entry.make(has_sublist(entry) ? node.sublist(entry.name) : node, std::forward<Context>(context)...);
  }

 private:
  static std::string described(const Entry& entry) {
    if (entry.source.empty()) return entry.sentence;
    return entry.sentence.substr(0, entry.sentence.size() - 1) + " (" + entry.source + ").";
  }
  static bool has_sublist(const Entry& entry) { return !entry.in_place && entry.parameters.numParams() > 0; }

  std::string choice_;
  std::string documentation_;
  std::vector<Entry> entries_;
};

}  // namespace ixos
