/// Motions of rigid bodies in a scene: of grips and of obstacles.
#pragma once
#include <string>
#include <vector>

#include "histories/rigid_motion.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"
#include "scene/read/histories.hpp"

namespace ixos {

/// The entries that name the histories of a rigid body.
struct MotionOptions {
  std::vector<std::string> translation{};  ///< histories by direction; "-" stands still
  std::string rotation{};                  ///< history; empty: none
  std::vector<double> axis{};
  std::vector<double> point{};

  /// Returns the name of the history that moves it along a direction; empty if none does.
  std::string along(std::size_t direction) const;
  /// Returns the names of its histories, each once.
  std::vector<std::string> histories() const;
  /// Returns "driven by history Press, Turn" or "held".
  std::string in_words() const;
};

/// Adds the entries to the options of a struct that derives from MotionOptions or is one. `body` is what moves;
/// `moment` a sentence on the moment, or empty.
template <class S>
void add_motion_options(Options<S>& options, const std::string& body, const std::string& moment) {
  options
      .add("Translation", &MotionOptions::translation,
           "Names of histories, one for each direction, that move the " + body +
               "; \"-\" stands still. If empty, it stands still.")
      .add("Rotation", &MotionOptions::rotation,
           "Name of a history, whose value is the angle of the " + body + "'s rotation. If empty, it does not turn.")
      .add("Axis", &MotionOptions::axis,
           "Direction of the axis of rotation in 3D [-], of any length. In 2D the " + body + " turns about z.",
           any_number())
      .add("Point", &MotionOptions::point,
           "Point through which the axis of rotation goes, in the reference configuration [L0]. " + moment +
               "It moves with Translation. If empty, it is the origin of coordinates.",
           any_number());
}

/// Throws InputError, with the entry's path, unless the array is empty or has an element for each dimension.
void check_length(const SceneNode& node, const char* entry, std::size_t length, int dimension);

/// Returns the motion that the entries of the list name. Throws InputError with the list path.
RigidMotion rigid_motion(const SceneNode& node, const MotionOptions& options, const Histories& histories,
                         int dimension);

}  // namespace ixos
