/// Meridian planes of bodies of revolution.
#pragma once
#include <vector>

#include "mesh/distributed_mesh.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// A node is on the axis if its radius is at most this share of the largest radius of the mesh: files and generators
/// round.
constexpr double axis_tolerance = 1e-10;

/// Throws InputError, naming the first bad node, if an axisymmetric mesh has three dimensions, or a node beyond the
/// axis (x < 0). Accepts all other meshes.
void check_meridian(const Mesh& mesh);

/// Does the same with a rank's part.
void check_meridian(const LocalMesh& mesh);

/// Returns the largest radius of a mesh's nodes, or of a rank's share of them [L0]; 0 if the mesh has none. Nodes that
/// stand for derivatives have no radius.
double largest_radius(const Mesh& mesh);
double largest_radius(const DistributedMesh& mesh);

/// Returns by local node whether it is on the axis: within axis_tolerance of the mesh's largest radius, so equal on all
/// ranks. Derivative nodes are not. Empty if the mesh is not axisymmetric.
std::vector<bool> nodes_on_axis(const LocalMesh& mesh);

}  // namespace ixos
