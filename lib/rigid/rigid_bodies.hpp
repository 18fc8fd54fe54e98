/// The rigid bodies of a model, and their numbers.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "rigid/rigid_body.hpp"

namespace ixos {

/// The bodies' numbers follow each other, RigidBody::numbers each.
class RigidBodies {
 public:
  RigidBodies() = default;
  /// Throws InputError if two bodies share a name.
  explicit RigidBodies(std::vector<RigidBody> bodies);

  bool empty() const { return bodies_.empty(); }
  std::size_t size() const { return bodies_.size(); }
  const RigidBody& operator[](std::size_t i) const { return bodies_[i]; }
  std::vector<RigidBody>::const_iterator begin() const { return bodies_.begin(); }
  std::vector<RigidBody>::const_iterator end() const { return bodies_.end(); }
  /// Returns the number of the body of that name; throws InputError, which lists the names, if there is none.
  std::size_t find(const std::string& name) const;
  /// Returns the place of a body's first number among those of all.
  static std::size_t first(std::size_t body) { return body * RigidBody::numbers; }
  int numbers() const { return static_cast<int>(first(size())); }
  /// Returns the places of the unknowns among the numbers of all.
  std::vector<int> free() const;

 private:
  std::vector<RigidBody> bodies_;
};

}  // namespace ixos
