/// Measures of a scene before its run, for the warnings.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mesh/cell_bending.hpp"
#include "mesh/cut_planes.hpp"
#include "scene/examine/characteristic_numbers.hpp"
#include "scene/read/driving.hpp"
#include "time/table.hpp"

namespace ixos {

/// The scales of a scene in SI units.
struct Scales {
  double length = 0;  ///< L0 [m]
  double stress = 0;  ///< E0 [Pa]
  double time = 0;    ///< T0 [s]
};

/// One interaction, parallel to CharacteristicNumbers::surfaces.
struct SurfaceFacts {
  int order = 1;        ///< of the contact element
  double peak_gap = 0;  ///< the gap of largest attraction [L0]
  double range = 0;     ///< of the law, infinite without one [L0]
  /// The gap at which neither repulsion nor attraction acts [L0]; none if the law only repels or only attracts.
  std::optional<double> rest_gap{};
  double repulsion = 0;       ///< at the least gap; 0 in attraction [E0]
  double attraction = 0;      ///< at the least gap less the approach; 0 beyond the range [E0]
  bool never_bonds = false;   ///< its bonds form at the start only, and it begins beyond their range
  bool moved = false;         ///< the obstacle is moved: its place at the start tells little
  bool opposed = true;        ///< this law or another one on the side set repels
  bool has_friction = false;  ///< some interaction of the side set has friction
  /// The name of another interaction of the side set and the same obstacle, whose traction the threshold of this one's
  /// friction does not count; empty if there is none.
  std::string uncounted{};
  /// Share of the surface's cells whose other side is a surface, too, and that lock in bending.
  double single_layer = 0;
  double layer_thickness = 0;  ///< mean thickness of those cells [L0]
  Drive drive{};               ///< of the body to which the surface belongs
  /// For a flat adhesive surface that is pulled without friction: the body's volume over that of a column which stands
  /// on the surface and is as thick as the body; otherwise, and beside further bodies, 0.
  double column = 0;
  /// A plane along the obstacle's normal at which the body may be cut out of a symmetric one, and on which nothing
  /// acts.
  std::optional<CutPlane> open_cut{};
};

/// The points of a double integral over two surfaces.
struct DensePoints {
  std::string name{};          ///< of the interaction
  double face_length = 0;      ///< see median_face_length(), of the surface with the longer ones [L0]
  int on_a_face = 1;           ///< per direction
  double equilibrium_gap = 0;  ///< [L0]
};

/// The cells of one body that may be too stiff.
struct BodyBending {
  CellBending cells{};          ///< of Standard cells of a nearly incompressible body along all directions
  double poissons_ratio = 0;    ///< at rest
  bool is_volumetric = false;   ///< the cells are Standard, and the body is nearly incompressible
  std::string stiff_cells{};    ///< type of linear cells that are no quadrilaterals or hexahedra; empty: none
  bool has_tetrahedra = false;  ///< there are quadratic tetrahedra, and they are Standard
};

/// A surface of two bodies with Smoothing Spline in space, with edges as SideGrid::OpenCreases.
struct OpenSurface {
  std::string name{};  ///< of the interaction
  std::string side_set{};
  int creases = 0;
  double angle = 0;  ///< the largest one between two faces
};

/// An obstacle that is another one at the two ends of a period of the mesh.
struct UnevenPeriod {
  std::string name{};               ///< of the interaction
  Vec<3> place{}, partner{};        ///< of two nodes of one place [L0]
  double gap = 0, partner_gap = 0;  ///< [L0]
};

struct SceneFacts {
  int dimension = 2;  ///< of the mesh
  CharacteristicNumbers numbers{};
  std::vector<BodyBending> bending{};  ///< parallel to CharacteristicNumbers::bodies
  std::vector<SurfaceFacts> surfaces{};
  std::vector<DensePoints> dense_points{};
  std::vector<OpenSurface> open_surfaces{};
  std::vector<UnevenPeriod> uneven_periods{};
  std::vector<Motion> motions{};
  bool loaded = false;  ///< there are loads
  bool moves = false;   ///< see Driving::moves(); or an obstacle is moved
  bool has_inertia = true;
  double step = 0;          ///< of fixed implicit steps, otherwise 0 [T0]
  double initial_time = 0;  ///< [T0]
  double duration = 0;      ///< of the run [T0]
  /// The longest step that the control allows, and for each body the shortest relaxation time of branches with the
  /// history update Second Order, infinite without [T0].
  double longest_step = 0;
  bool adaptive = false;  ///< steps are
  std::vector<double> relaxation_times{};
  std::optional<Scales> scales{};
};

/// Returns the facts of a validated scene; `mesh` is whole and may be enriched. `parts`: see connected_parts(). Leaves
/// out the scales.
SceneFacts scene_facts(const SceneNode& scene, CharacteristicNumbers numbers, const std::vector<Material>& materials,
                       const std::vector<SceneInteraction>& interactions, const Mesh& mesh,
                       const std::vector<int>& parts, const Histories& histories, const StepControlOptions& control,
                       Inertia inertia);

}  // namespace ixos
