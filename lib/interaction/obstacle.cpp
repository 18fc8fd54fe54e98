#include "interaction/obstacle.hpp"

#include "fem/quadrature.hpp"

namespace ixos {

MeanSight Obstacle::mean(const PackPoint& x0, const PackPoint& x1) const {
  static const Quadrature gauss = gauss_legendre_unit(3);
  MeanSight result{};
  for (std::size_t q = 0; q < gauss.points.size(); ++q) {
    const double xi = gauss.points[q], weight = gauss.weights[q];
    PackPoint x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = (1 - xi) * x0[i] + xi * x1[i];
    const Sight sight = at(x);
    for (std::size_t i = 0; i < 3; ++i) {
      result.normal[i] += weight * sight.normal[i];
      for (std::size_t j = 0; j < 3; ++j) result.slope[i][j] += (weight * xi) * sight.bend[i][j];
    }
  }
  return result;
}

Pack Obstacle::admissible_step(const PackPoint& x, const PackPoint& d, const Pack& least) const {
  Pack square = 0.0;
  for (const Pack& component : d) square += component * component;
  const Pack length = select(square > 0.0, Pack(std::experimental::sqrt(square)), Pack(1.0));
  Pack step = 0.0;
  // A round goes as far as the gap at its start allows. Six rounds reach 0.998 of the way in the median.
  for (int round = 0; round < 6; ++round) {
    PackPoint there;
    for (std::size_t i = 0; i < 3; ++i) there[i] = x[i] + step * d[i];
    const Pack room = at(there).gap - least;
    step = smaller(Pack(step + select(room > 0.0, room, Pack(0.0)) / length), Pack(1.0));
  }
  return select(square > 0.0, step, Pack(1.0));
}

}  // namespace ixos
