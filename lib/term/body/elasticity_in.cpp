#include "term/body/elasticity_in.hpp"

#include <limits>

#include "element/cell_means.hpp"

namespace ixos {
namespace {

/// Returns the means of value(H), an array of numbers, over the reference volumes.
template <class Space, class Value>
auto mean(const SeenPoints<Space>& points, const Value& value) {
  return mean_over(points.h.size(), points.volumes.data(), [&](std::size_t q) { return value(points.h[q]); });
}

}  // namespace

template <class Space>
double ElasticityIn<Space>::energy(const Place& at) const {
  std::vector<Pack> w;
  Pack sum = 0.0;
  for_each_seen(at.u, [&](const Seen& seen) {
    w.resize(seen.h.size());
    points_law().energy(w.size(), seen.h.data(), w.data());
    Pack own = 0.0;
    for (std::size_t q = 0; q < w.size(); ++q) own += seen.volumes[q] * w[q];
    sum += seen.owned * select(seen.found > 0.0, own, Pack(std::numeric_limits<double>::quiet_NaN()));
  });
  return total(sum);
}

template <class Space>
void ElasticityIn<Space>::cell_fields(const double* u, CellFields& fields) const {
  const double scale = youngs_modulus(law_->lame());
  for (std::vector<double>* field : {&fields.stress_invariant, &fields.jacobian, &fields.energy_density})
    field->resize(cells());
  for_each_seen(u, [&](const Seen& seen) {
    const auto means = mean(seen, [&](const auto& h) { return invariants(*law_, h); });
    for (std::size_t lane = 0; lane < seen.lanes; ++lane) {
      fields.stress_invariant[seen.first + lane] = means[0][lane] / scale;
      fields.jacobian[seen.first + lane] = means[1][lane];
      fields.energy_density[seen.first + lane] = means[2][lane];
    }
  });
}

template <class Space>
void ElasticityIn<Space>::cell_stress(const double* u, std::vector<SymmetricTensor>& stress) const {
  const bool finite = points_law().can_invert();
  stress.resize(cells());
  for_each_seen(u, [&](const Seen& seen) {
    const auto means = mean(seen, [&](const auto& h) { return cauchy_stress(*law_, h, finite); });
    for (std::size_t lane = 0; lane < seen.lanes; ++lane)
      for (std::size_t i = 0; i < means.size(); ++i) stress[seen.first + lane][i] = means[i][lane];
  });
}

template class ElasticityIn<PlaneSpace>;
template class ElasticityIn<SolidSpace>;
template class ElasticityIn<RingSpace>;

}  // namespace ixos
