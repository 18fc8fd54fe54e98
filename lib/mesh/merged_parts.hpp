/// Parts of a joined mesh that share faces.
#pragma once
#include <vector>

#include "mesh/joined_parts.hpp"

namespace ixos {

/// Makes one node of nodes of different parts that are no farther apart than `tolerance` [L0]: parts that touch are
/// bonded. It stands where that of the first part stood. `parts`: those that joined_parts() joined. Sides that two
/// cells have then leave the side sets, and sets without sides go; a note tells how many nodes were merged.
///
/// Throws InputError if there are none, if nodes are tied already, if the tolerance would make one node of two of one
/// part, or if two parts touch with faces that do not match: then their nodes would be apart where the faces are not.
void merge_parts(const std::vector<MeshPart>& parts, double tolerance, Mesh& mesh);

}  // namespace ixos
