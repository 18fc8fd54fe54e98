/// The box of the tests of sides.
#pragma once
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/contact_element.hpp"
#include "support/scene_text.hpp"

namespace ixos::test {

/// This rank's part of a box whose "bottom" is enriched.
inline LocalMesh box_part(int dimension, ContactElement element) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lower = {0.1, -0.4, 0.3};
  shape.lengths = {2.0, 1.5, 1.0};
  shape.divisions = {3, 2, 2};
  Mesh whole = box(shape);
  give_contact_element(whole, "bottom", element);
  const Comm comm = world();
  return localize(whole, partition_nodes(whole, comm->getSize()), comm->getRank(), comm->getSize());
}

}  // namespace ixos::test
