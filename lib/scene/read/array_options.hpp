/// The parameters of repeated parts.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <vector>

#include "parameters/scene_node.hpp"

namespace ixos {

/// Where copies stand, see the documentation of the parameters.
enum class ArrayLayout { Once, Grid, Ring, Table };

struct ArrayGrid {
  std::vector<int> counts;
  std::vector<double> spacing;
  double stagger = 0;
};

struct ArrayRing {
  int count = 8;
  double radius = 1;
  bool turn = true;
};

struct ArrayPlaces {
  std::vector<double> places, angles, scales;
};

struct ArrayDisorder {
  int seed = 1;
  bool normal = false;
  std::vector<double> place;
  double angle = 0, inclination = 0, scale = 0;
  Teuchos::ParameterList parameters;
};

struct ArrayOptions {
  ArrayLayout layout = ArrayLayout::Once;
  std::vector<double> point;
  ArrayGrid grid;
  ArrayRing ring;
  ArrayPlaces table;
  ArrayDisorder disorder;
};

/// Adds the parameters to the valid list of a part, and reads them.
void declare_array(Teuchos::ParameterList& part);
ArrayOptions read_array(const SceneNode& part);

}  // namespace ixos
