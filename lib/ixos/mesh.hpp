/// Meshes of the program's own, whole or distributed, and simple ones made in memory.
///
/// A program fills in a Mesh, which is whole and the same on all ranks, or a DistributedMesh, of which each rank has
/// its own nodes and cells with its own ids. local_part() checks either and makes the LocalMesh that a Model takes.
///
/// Stable: Mesh, ElementBlock, Side, SideSet, NodeSet, CellType, DistributedMesh, DistributedBlock,
/// DistributedNodeSet, LocalMesh, local_part, partition_nodes, raise_order, add_bubbles, place_bubbles,
/// ContactElement, enrich, DiskShape, disk, BoxShape, box, MeshPart, joined_parts, Placement, move_nodes, Tie,
/// RefinedRegion, NamedRegion, refine, tie_surfaces, make_periodic.
#pragma once
#include "fem/cell_type.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/distributed_mesh.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/mesh.hpp"
#include "mesh/mortar/tied_surfaces.hpp"
#include "mesh/partition.hpp"
#include "mesh/periodic_sides.hpp"
#include "mesh/placement.hpp"
#include "mesh/splitting/refine.hpp"
