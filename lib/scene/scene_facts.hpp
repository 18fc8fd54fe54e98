/// Measures of a scene before its run, for the warnings.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scene/characteristic_numbers.hpp"
#include "scene/histories.hpp"
#include "time/step_control.hpp"
#include "time/table.hpp"

namespace ixos {

/// The scales of a scene in SI units.
struct Scales {
  double length = 0;  ///< L0 [m]
  double stress = 0;  ///< E0 [Pa]
  double time = 0;    ///< T0 [s]
};

/// A prescribed displacement that a history drives.
struct Motion {
  std::string path;        ///< of the condition
  double start = 0;        ///< value at the initial time [L0]
  double start_speed = 0;  ///< magnitude of its rate then, less the initial velocity [L0/T0]
  double range = 0;        ///< largest less least value over the run [L0]
  double in_one_step = 0;  ///< its largest change in a fixed step [L0]
};

/// The directions in which a body is pulled, seen from one obstacle: the sum of the motions of one node set, or a load.
struct Pull {
  std::string path;  ///< of a condition
  double along = 0;  ///< largest magnitude along the obstacle's surface
  double away = 0;   ///< largest value away from the obstacle, in the same unit
};

/// One interaction, parallel to CharacteristicNumbers::surfaces.
struct SurfaceFacts {
  int order = 1;          ///< of the contact element
  double peak_gap = 0;    ///< the gap of largest attraction [L0]
  double approach = 0;    ///< way towards the obstacle that motions and initial velocities prescribe [L0]
  double attraction = 0;  ///< at the least gap less the approach; 0 beyond the range [E0]
  double single_layer =
      0;  ///< share of the surface's cells whose other side is a surface, too, and that lock in bending
  double layer_thickness = 0;  ///< mean thickness of those cells [L0]
  std::vector<Pull> pulls{};
};

struct SceneFacts {
  CharacteristicNumbers numbers{};
  std::vector<SurfaceFacts> surfaces{};
  std::vector<Motion> motions{};
  bool held = false;    ///< some displacement is prescribed
  bool loaded = false;  ///< there are loads
  bool moves = false;   ///< there is an initial velocity
  bool has_inertia = true;
  double step = 0;      ///< of fixed implicit steps, otherwise 0 [T0]
  double duration = 0;  ///< of the run [T0]
  std::optional<Scales> scales{};
};

/// Returns the facts of a validated scene; `mesh` is whole and may be enriched. Does not know the scales.
SceneFacts scene_facts(const SceneNode& scene, CharacteristicNumbers numbers, const std::vector<Material>& materials,
                       const std::vector<SceneInteraction>& interactions, const Mesh& mesh, const Histories& histories,
                       const StepControlOptions& control, Inertia inertia);

}  // namespace ixos
