/// The parameters of a struct, declared once for documentation, validation and reading.
#pragma once
#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "parameters/one_of.hpp"
#include "parameters/scene_node.hpp"
#include "parameters/validation.hpp"

namespace ixos {

/// Each entry names a member of S, its documentation and what is allowed; the member's value in S{} is the default.
/// list() gives the valid list, read() the struct from a list that the validation has completed.
template <class S>
class Options {
  using List = Teuchos::ParameterList;

 public:
  using Validator = Teuchos::RCP<const Teuchos::ParameterEntryValidator>;
  template <class E>
  using Words = std::vector<std::pair<std::string, E>>;

  /// A member, of S or of a base of it, of type double, int, bool, std::string, or std::vector of double, int or
  /// std::string. If it belongs to a word of choose_one() and the validation has left it out, the member keeps its
  /// value in S{}.
  template <class B, class V>
  Options& add(const char* name, V B::*member, const std::string& documentation,
               const Validator& validator = Teuchos::null) {
    return entry(
        name,
        [=](List& list) {
          list.set(name, stored(S{}.*member), documentation);
          if (nonnull(validator)) list.getEntry(name).setValidator(validator);
        },
        [=](const SceneNode& node, S& target) { target.*member = loaded(node, name, target.*member); });
  }

  /// A number that the user must give, unless the validation leaves it out as above.
  template <class B>
  Options& require(const char* name, double B::*member, const std::string& documentation, const Validator& validator) {
    return entry(
        name, [=](List& list) { set_required(list, name, documentation, validator); },
        [=](const SceneNode& node, S& target) { target.*member = node.number(name); });
  }

  /// A choice among words that stand for the values of an enumeration.
  template <class B, class E>
  Options& choose(const char* name, E B::*member, const Words<E>& words, const std::string& documentation) {
    return choice(name, member, words, documentation, one_of(names_of(words)));
  }

  /// A choice to which other entries of the list belong: the validation refuses what belongs to other words, see
  /// exclusive_choice_of().
  template <class B, class E>
  Options& choose_one(const char* name, E B::*member, const Words<E>& words,
                      const std::vector<Choice::Word>& belongings, const std::string& documentation) {
    for (const Choice::Word& word : belongings) belongings_.insert(word.belongings.begin(), word.belongings.end());
    return choice(name, member, words, documentation, exclusive_choice_of(belongings));
  }

  /// A choice among words that may also be names of sublists: the validation completes only the sublist of the chosen
  /// word, see choice_of().
  template <class B, class E>
  Options& choose_list(const char* name, E B::*member, const Words<E>& words, const std::string& documentation) {
    return choice(name, member, words, documentation, choice_of(names_of(words)));
  }

  /// A sublist, read into a member that is a struct itself. The defaults are those of T{}. If the validation has left
  /// the list out, the member keeps its value in S{}.
  template <class B, class T>
  Options& sublist(const char* name, T B::*member, const Options<T>& options, const std::string& documentation) {
    return entry(
        name, [=](List& list) { options.declare(list.sublist(name, false, documentation)); },
        [=](const SceneNode& node, S& target) {
          if (node.list().isSublist(name)) target.*member = options.read(node.sublist(name));
        });
  }

  /// A sublist whose entries another library checks.
  template <class B>
  Options& free_form(const char* name, List B::*member, const std::string& documentation) {
    return entry(
        name, [=](List& list) { mark_free_form(list.sublist(name, false, documentation)); },
        [=](const SceneNode& node, S& target) {
          const List& given = node.list().sublist(name);
          target.*member = given;
          (target.*member).setName(given.name());
        });
  }

  /// Adds the entries to a valid list. Throws std::logic_error if the list has an entry of that name.
  void declare(List& list) const {
    for (const Entry& e : entries_) {
      if (list.isParameter(e.name)) throw std::logic_error("\"" + e.name + "\" is declared twice");
      e.declare(list);
    }
  }
  List list() const {
    List result;
    declare(result);
    return result;
  }
  /// Throws if the list lacks an entry that belongs to no word of choose_one().
  S read(const SceneNode& node) const {
    S result;
    for (const Entry& e : entries_)
      if (node.list().isParameter(e.name) || belongings_.count(e.name) == 0) e.read(node, result);
    return result;
  }

 private:
  struct Entry {
    std::string name;
    std::function<void(List&)> declare;
    std::function<void(const SceneNode&, S&)> read;
  };

  Options& entry(const char* name, std::function<void(List&)> declare, std::function<void(const SceneNode&, S&)> read) {
    entries_.push_back({name, std::move(declare), std::move(read)});
    return *this;
  }

  template <class E>
  static std::vector<std::string> names_of(const Words<E>& words) {
    std::vector<std::string> names;
    for (const auto& word : words) names.push_back(word.first);
    return names;
  }

  template <class B, class E>
  Options& choice(const char* name, E B::*member, const Words<E>& words, const std::string& documentation,
                  const Validator& validator) {
    return entry(
        name,
        [=](List& list) {
          for (const auto& [word, value] : words)
            if (value == S{}.*member) list.set(name, word, documentation, validator);
          if (!list.isParameter(name)) throw std::logic_error(std::string(name) + ": its default is none of the words");
        },
        [=](const SceneNode& node, S& target) {
          for (const auto& [word, value] : words)
            if (word == node.text(name)) target.*member = value;
        });
  }

  template <class V>
  static const V& stored(const V& value) {
    return value;
  }
  template <class V>
  static Teuchos::Array<V> stored(const std::vector<V>& values) {
    return Teuchos::Array<V>(values);
  }
  template <class V>
  static V loaded(const SceneNode& node, const char* name, const V& /*type*/) {
    return node.get<V>(name);
  }
  template <class V>
  static std::vector<V> loaded(const SceneNode& node, const char* name, const std::vector<V>& /*type*/) {
    return node.get<Teuchos::Array<V>>(name).toVector();
  }

  std::vector<Entry> entries_;
  std::set<std::string> belongings_;  ///< names that belong to a word of choose_one()
};

}  // namespace ixos
