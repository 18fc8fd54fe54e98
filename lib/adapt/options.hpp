/// How a mesh follows the front.
#pragma once
#include <string>

namespace ixos {

/// The most levels, and the least part, that a scene may ask for.
constexpr int most_adapt_levels = 12;
constexpr double least_adapt_part = 1e-3;

/// The settings of a scene's list "Mesh/Adapt".
struct AdaptOptions {
  int levels = 0;            ///< halvings of an edge at most; 0: the mesh stays
  double part = 0.25;        ///< change of the traction over a face at most, over the law's strength
  double strain = 0;         ///< jump of the displacement gradient between cells at most; 0: any
  double keep = 0.5;         ///< cells stay split while a change is above this part of its bound, in (0, 1)
  int interval = 10;         ///< steps from one look for cells that need not be split to the next
  double budget = 1e-3;      ///< changes of energy by coarser cells, over the run's largest energy, at most
  std::string directions{};  ///< axes along which cells are split, such as "xy"; empty: all

  bool on() const { return levels > 0; }
};

}  // namespace ixos
