/// Rigid bodies from one step to the next.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "state/state.hpp"

namespace ixos {

/// Sets the attitudes of the bodies in a guess, a local array, to those at the step's start.
void keep_attitudes(const Model& model, const std::vector<double>& start, std::vector<double>& guess);

/// Sets what histories move, in local arrays of displacements, velocities and accelerations at a time; each may be
/// null.
void drive_bodies(const Model& model, double time, double* u, double* v, double* a);

/// Returns whether what moves bodies is defined at a time.
bool bodies_are_finite(const Model& model, double time);

/// Sets displacements and velocities of the nodes that bodies carry, in an accepted state.
void carry_nodes(const Model& model, double* u, double* v);

/// Makes the end of a step the start of one: rotations pass into attitudes. `rates`: the end has the rates of rotation
/// vectors, which become spins. `past`: earlier displacements, whose rotations are seen from the new start, to first
/// order; empty ones stay so.
void begin_body_steps(const Model& model, bool rates, State& end, const std::vector<std::vector<double>*>& past);

/// Sets the accelerations of the bodies from a state and from `forces`, less the sum of forces, shares of ranks. All
/// arrays are local. Returns the forces, summed over ranks, by number. Collective.
std::vector<double> solve_body_accelerations(const Model& model, const double* u, const double* v, const double* forces,
                                             double* a);

}  // namespace ixos
