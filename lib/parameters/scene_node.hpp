/// A list of a scene that knows its path.
#pragma once
#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace ixos {

/// Returns the message with the list path before it, or the message itself if it begins with that path.
std::string placed(const std::string& path, const std::string& message);

/// Calls a function, and puts the list path before the message of an InputError that it throws, unless the message
/// begins with it already.
template <class Function>
auto at(const std::string& path, const Function& function) {
  try {
    return function();
  } catch (const InputError& error) {
    throw InputError(placed(path, error.what()));
  }
}

/// A validated list and its path from the scene's root, "Interactions/Wall", for messages. It refers to the list, which
/// must outlive it.
class SceneNode {
 public:
  using List = Teuchos::ParameterList;

  /// `path`: the list's path; without `name` its last part is the list's name.
  SceneNode(const List& list, const std::string& path) : SceneNode(list, path, path.substr(path.rfind('/') + 1)) {}
  SceneNode(const List& list, std::string path, std::string name)
      : list_(&list), path_(std::move(path)), name_(std::move(name)) {}

  const List& list() const { return *list_; }
  const std::string& path() const { return path_; }
  /// Returns the name that the user gave the list. It may contain a slash.
  const std::string& name() const { return name_; }
  /// Returns the path of an entry.
  std::string path_of(const std::string& entry) const { return path_.empty() ? entry : path_ + "/" + entry; }

  /// Returns the value of an entry, which the validation has put there.
  template <class T>
  const T& get(const std::string& entry) const {
    return list_->get<T>(entry);
  }
  double number(const std::string& entry) const { return get<double>(entry); }
  int count(const std::string& entry) const { return get<int>(entry); }
  const std::string& text(const std::string& entry) const { return get<std::string>(entry); }
  std::vector<double> numbers(const std::string& entry) const { return get<Teuchos::Array<double>>(entry).toVector(); }
  /// Returns an array of `count` numbers, or `fallback` if the user gave none. Throws InputError.
  std::vector<double> numbers(const std::string& entry, std::size_t count, std::vector<double> fallback) const;

  /// Returns the sublist of that name.
  SceneNode sublist(const std::string& entry) const { return {list_->sublist(entry), path_of(entry), entry}; }
  /// Returns all sublists, in order.
  std::vector<SceneNode> sublists() const;

  /// Throws InputError "path/entry: why"; without an entry "path: why", and at the root "why".
  [[noreturn]] void refuse(const std::string& entry, const std::string& why) const;
  /// Throws InputError "path/entry: value why" for an entry of the list, or of a sublist ("Friction/Type"). An empty
  /// value stands for the entry's own, a word; a list has none.
  [[noreturn]] void refuse_value(const std::string& entry, const std::string& value, const std::string& why) const;

 private:
  const List* list_;
  std::string path_;
  std::string name_;
};

}  // namespace ixos
