/// The nodes that rigid bodies carry, in a stage.
#pragma once
#include <cstddef>
#include <vector>

#include "model/model.hpp"
#include "term/border.hpp"

namespace ixos {

/// Forces on carried nodes act on their bodies, and the tangent's rows and columns of these nodes pass into the border.
/// It is of one version of the discretization. Not collective: sums are shares of ranks.
class CarriedGrips {
 public:
  explicit CarriedGrips(const Model& model);

  /// `mean`: the stage balances momentum over the step, see BodySight; `start`: the step's start.
  void arm(const double* start, bool mean) { start_ = mean ? start : nullptr; }
  /// Returns whether an owned degree of freedom is that of a carried node.
  bool carries(std::size_t dof) const { return carried_[dof]; }
  /// Adds the forces to those on globals, by number; f has the forces on owned nodes, their inertia included.
  void add_forces(const double* u, const double* f, double* globals) const;
  /// Adds to the border's columns what the nodes' motions make in all rows; `values` is the tangent, condensed, without
  /// constraints.
  void add_columns(const double* u, const double* values, Border& border) const;
  /// Then, after the columns were condensed, adds rows and block.
  void add_rows(const double* u, const double* f, const double* values, Border& border) const;

 private:
  /// The block of a carried node and another one.
  struct Block {
    std::size_t first, stride;  ///< in the matrix values
    std::size_t share, other;   ///< number of the carried node, first degree of freedom of the other one
  };
  struct Grip {
    const CarriedNodes* nodes;
    std::size_t first;                 ///< number of the body among the globals
    std::vector<Block> columns, rows;  ///< the carried node is the column, or the row
  };
  const Model& model_;
  std::size_t d_;
  std::vector<Grip> grips_;
  std::vector<bool> carried_;  ///< by owned degree of freedom
  const double* start_ = nullptr;
};

}  // namespace ixos
