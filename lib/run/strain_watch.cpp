#include "run/strain_watch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/quality.hpp"
#include "model/state_report.hpp"

namespace ixos {

void StrainWatch::look(const Model& model, const Place& at) {
  const LocalMesh& mesh = model.mesh();
  StrainExtremes now;
  // Without the velocity: the invariant of the elastic law alone.
  for (const CellFields& fields : StateReport(model, Place{at.u, at.time, at.histories}).cell_fields()) {
    for (double value : fields.jacobian) {
      now.least_jacobian = std::min(now.least_jacobian, value);
      now.largest_jacobian = std::max(now.largest_jacobian, value);
    }
    for (double value : fields.stress_invariant)
      now.largest_invariant = std::max(now.largest_invariant, std::abs(value));
  }
  std::vector<double> places(mesh.coordinates);
  for (std::size_t i = 0; i < places.size(); ++i) places[i] += at.u[i];
  for (const LocalBlock& block : mesh.blocks)
    now.least_scaled_jacobian =
        std::min(now.least_scaled_jacobian, least_scaled_jacobian(block.type, block.nodes, places));
  const DofSpace& space = model.space();
  extremes_.least_jacobian = std::min(extremes_.least_jacobian, space.minimum(now.least_jacobian));
  extremes_.largest_jacobian = std::max(extremes_.largest_jacobian, space.maximum(now.largest_jacobian));
  extremes_.largest_invariant = std::max(extremes_.largest_invariant, space.maximum(now.largest_invariant));
  const double scaled = space.minimum(now.least_scaled_jacobian);
  if (scaled >= extremes_.least_scaled_jacobian) return;
  extremes_.least_scaled_jacobian = scaled;
  extremes_.time = at.time;
}

void StrainWatch::transfer(Record& record) {
  const Record::Section section(record, "strains");
  record.number("least jacobian", extremes_.least_jacobian);
  record.number("largest jacobian", extremes_.largest_jacobian);
  record.number("largest invariant", extremes_.largest_invariant);
  record.number("least scaled jacobian", extremes_.least_scaled_jacobian);
  record.number("time", extremes_.time);
}

}  // namespace ixos
