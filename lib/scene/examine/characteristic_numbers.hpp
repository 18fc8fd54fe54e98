/// The lengths, speeds and times that characterise a scene.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/read/interactions.hpp"

namespace ixos {

/// Numbers of the cells of one list of "Materials".
struct BodyNumbers {
  std::string name;          ///< of the list
  std::size_t material = 0;  ///< its number among the lists
  double modulus = 0;        ///< Young's modulus E [E0]
  double plane_modulus = 0;  ///< E* = E/(1 - nu^2) [E0]
  double density = 0;        ///< rho [E0 T0^2/L0^2]
  double wave_speed = 0;     ///< of compression waves, sqrt((lambda + 2 mu)/rho) [L0/T0]
  double size = 0;           ///< longest side of the box around the cells of a connected part [L0]
  double crossing_time = 0;  ///< size over wave speed [T0]
};

/// Numbers of one list of "Interactions".
struct SurfaceNumbers {
  std::string name;                ///< of the list
  std::size_t interaction = 0;     ///< its number among the interactions
  std::size_t side_set = 0;        ///< of the mesh
  std::size_t body = 0;            ///< of CharacteristicNumbers::bodies, to which the first side belongs
  int part = 0;                    ///< to which it belongs, see connected_parts()
  double work = 0;                 ///< W of adhesion, with the cutoff, see work_of_adhesion() [E0 L0]
  double peak_traction = 0;        ///< s0, the largest attraction [E0]
  bool never_bonds = false;        ///< W = s0 = 0: it begins beyond the range of bonds that form at the start only
  bool is_electrode = false;       ///< of the law Electrostatic: it attracts from afar, and nothing comes off
  double equilibrium_gap = 0;      ///< r_eq [L0]
  double elastic_length = 0;       ///< elasto-adhesive length W/E [L0]
  double cohesive_zone = 0;        ///< see cohesive_zone() [L0]
  double face_length = 0;          ///< see median_face_length() [L0]
  double least_gap = 0;            ///< at the nodes of the surface, before any displacement [L0]
  double largest_gap = 0;          ///< likewise [L0]
  std::array<double, 3> normal{};  ///< out of the obstacle at the node of least gap
  double extent = 0;               ///< the shorter one of the set, across the normal; see extent_of() [L0]
  double thickness = 0;            ///< extent of that part along the normal [L0]
  /// R with 1/R = 1/R of a disk or a ball + 1/R of a curved obstacle, else as the nodes near the least gap have it; 0
  /// if the surface is not round there [L0]
  double radius = 0;
  double tabor = 0;              ///< (R W^2/(E*^2 r_eq^3))^(1/3); 0 if R is not known [-]
  double attraction_speed = 0;   ///< of a layer of that thickness that has lost W, sqrt(2 W/(rho thickness)) [L0/T0]
  double gap_crossing_time = 0;  ///< r_eq over that speed [T0]
};

struct CharacteristicNumbers {
  std::vector<BodyNumbers> bodies;       ///< materials whose block the mesh has
  std::vector<SurfaceNumbers> surfaces;  ///< interactions with an obstacle whose side set lies on such a body
  std::vector<SurfaceNumbers> pairs;     ///< interactions of two surfaces on such bodies, see add_pair()
};

/// Returns the median of the sides' lengths; in 3D the root of that of their areas [L0]. The mean would
/// follow a few long faces far from the contact. 0 without sides.
double median_face_length(const Mesh& mesh, const SideSet& set);

/// Returns the length of the zone in which a crack's faces attract each other [L0]: E* W/s0^2 (Hillerborg, Modeer and
/// Petersson 1976), but no more than (2 E* W h^3/(3 s0^2))^(1/4), at which the constant traction s0 bends a plate of
/// thickness h off the wall with the work W (M^2 = 2 E* h^3/12 W for the moment M = s0 l^2/2 per width).
double cohesive_zone(double plane_modulus, double work, double peak_traction, double thickness);

/// Sets the radius [L0] and Tabor's number of a surface whose law is known; `plane_modulus`: E* [E0].
void add_tabor(double radius, double plane_modulus, SurfaceNumbers& numbers);

/// Returns the height of a column whose weight compresses its foot by a stress of Young's modulus [L0]; `weight` per
/// volume [E0/L0], positive.
inline double gravity_length(double modulus, double weight) { return modulus / weight; }

/// Returns the numbers of a validated scene; `materials` and `interactions` are those of its lists, and `mesh` may be
/// enriched. `parts`: see connected_parts(). Leaves out what refers to absent blocks and sets, which others refuse.
CharacteristicNumbers characteristic_numbers(const SceneNode& scene, const std::vector<Material>& materials,
                                             const std::vector<SceneInteraction>& interactions, const Mesh& mesh,
                                             const std::vector<int>& parts);

}  // namespace ixos
