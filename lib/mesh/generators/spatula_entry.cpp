// The spatula in the catalogue of meshes.
#include "mesh/generators/entry.hpp"
#include "mesh/generators/spatula.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {

MeshEntry spatula_mesh() {
  Options<SpatulaShape> options;
  options
      .add("Pad Length", &SpatulaShape::pad_length, "Length of the pad from its rear end to its tip [L0].",
           greater_than(0))
      .add("Neck Width", &SpatulaShape::neck_width, "Width of the pad at its rear end [L0].", greater_than(0))
      .add("Tip Width", &SpatulaShape::tip_width, "Largest width of the pad [L0]. It must be at least Neck Width.",
           greater_than(0))
      .add("Widening Length", &SpatulaShape::widening_length,
           "Length over which the pad widens, from its rear end [L0]. The half-width grows as s^2 (3 - 2 s), with s "
           "from 0 to 1.",
           greater_than(0))
      .add("Tip Length", &SpatulaShape::tip_length,
           "Length of the half ellipse that ends the outline [L0]. It must be at most Pad Length minus Widening "
           "Length.",
           greater_than(0))
      .add("Rear Thickness", &SpatulaShape::rear_thickness,
           "Thickness of the pad at its rear end [L0]. It varies linearly from there to the tip.", greater_than(0))
      .add("Tip Thickness", &SpatulaShape::tip_thickness, "Thickness of the pad at its tip [L0].", greater_than(0))
      .add("Transition Length", &SpatulaShape::transition_length,
           "Length, along the centreline, of the transition from the pad's rectangular section to the shaft's disk "
           "[L0]. It must be at least the arc length of the fillet.",
           greater_than(0))
      .add("Fillet Radius", &SpatulaShape::fillet_radius,
           "Radius of the arc of the centreline that is tangent to pad and shaft [L0]. It must be greater than half "
           "of Shaft Diameter and half of Rear Thickness.",
           greater_than(0))
      .add("Shaft Diameter", &SpatulaShape::shaft_diameter, "Diameter of the shaft [L0].", greater_than(0))
      .add("Shaft Length", &SpatulaShape::shaft_length, "Length of the shaft beyond the transition [L0].",
           greater_than(0))
      .add("Inclination", &SpatulaShape::inclination, "Angle between shaft and pad [degrees].",
           greater_than_and_at_most(0, 90))
      .add("Gap", &SpatulaShape::gap,
           "Distance from the wall z = 0 to the flat underside of the pad [L0]. The default is the equilibrium gap of "
           "the default interaction.",
           greater_than(0))
      .add("Core Cells", &SpatulaShape::core_cells,
           "Number of cells across the core of a cross-section. It must be even.", between(4, 1000))
      .add("Core Layers", &SpatulaShape::core_layers, "Number of layers of cells through the core.", between(1, 100))
      .add("Rings", &SpatulaShape::rings, "Number of layers of cells around the core.", between(1, 100))
      .add("Tip Rows", &SpatulaShape::tip_rows,
           "Number of rows of cells that turn around the tip. It must be less than half of Core Cells.",
           between(1, 499))
      .add("Stations", &SpatulaShape::stations,
           "Number of cells along the centreline, at least 3. With 0, Target Cells determines it.", between(0, 100000))
      .add("Target Cells", &SpatulaShape::target_cells,
           "Approximate number of cells of the mesh, used if Stations is 0. Below 50,000 the cross-sections get fewer "
           "cells than given above.",
           between(200, 20000000))
      .add("Growth", &SpatulaShape::growth, "Ratio of the cell length in the shaft to that in the pad [-].",
           between(1, 100))
      .add("Layer Ratio", &SpatulaShape::layer_ratio,
           "Ratio of the thickness of the pad's uppermost layer of cells to that of its lowest [-].", between(1, 100));
  return {"Spatula",
          "A gecko's spatula of hexahedra. It has the block \"body\", the side and node sets \"pad\" (its underside), "
          "\"shaft end\" and \"surface\", and the node set \"tip\".",
          "",
          options.list(),
          [options](const SceneNode& node) { return spatula(options.read(node)); },
          false,
          3};
}

}  // namespace ixos
