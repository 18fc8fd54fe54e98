#include "rigid/rigid_bodies.hpp"

#include <utility>

#include "base/closest_name.hpp"
#include "base/error.hpp"

namespace ixos {

RigidBodies::RigidBodies(std::vector<RigidBody> bodies) : bodies_(std::move(bodies)) {
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (bodies_[i].name() == bodies_[j].name())
        throw InputError("two rigid bodies have the name \"" + bodies_[i].name() + "\"");
}

std::size_t RigidBodies::find(const std::string& name) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < size(); ++i) {
    if (bodies_[i].name() == name) return i;
    names.push_back(bodies_[i].name());
  }
  throw InputError(no_such("rigid body", name, names, "The model has"));
}

std::vector<int> RigidBodies::free() const {
  std::vector<int> all;
  for (std::size_t i = 0; i < size(); ++i)
    for (const std::size_t k : bodies_[i].free()) all.push_back(static_cast<int>(first(i) + k));
  return all;
}

}  // namespace ixos
