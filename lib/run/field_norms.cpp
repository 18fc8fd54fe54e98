#include "run/field_norms.hpp"

#include <cmath>

#include "discretization/volume_squares.hpp"

namespace ixos {

FieldNorms::FieldNorms(const std::vector<std::string>& names, const Model& model) : fields_(norm_fields(names, model)) {
  if (fields_.empty()) return;
  volumes_ = owned_volumes(model.mesh());
  for (const std::vector<double>& block : volumes_)
    for (double volume : block) volume_ += volume;
  model.space().sum(&volume_, 1);
}

double FieldNorms::cell_square(const OutputField& field, FieldFrame& frame) const {
  const CellValues values = field.cell(frame);
  double sum = 0;
  for (std::size_t component = 0; component < values.size(); ++component) {
    const double times = field.shape == FieldShape::Symmetric && component >= 3 ? 2 : 1;  // XY stands for YX, too
    for (std::size_t block = 0; block < volumes_.size(); ++block)
      for (std::size_t cell = 0; cell < volumes_[block].size(); ++cell) {
        if (volumes_[block][cell] == 0) continue;
        const double value = values[component][block][cell];
        sum += times * value * value * volumes_[block][cell];
      }
  }
  return sum;
}

std::vector<double> FieldNorms::values(Integrator& integrator) const {
  if (fields_.empty()) return {};
  FieldFrame frame(integrator);
  std::vector<double> norms;
  for (const OutputField& field : fields_)
    norms.push_back(field.nodal ? nodal_square(frame.model().mesh(), field.nodal(frame)) : cell_square(field, frame));
  frame.model().space().sum(norms.data(), static_cast<int>(norms.size()));
  for (double& norm : norms) norm = std::sqrt(norm / volume_);
  return norms;
}

}  // namespace ixos
