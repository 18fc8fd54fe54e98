#include "interaction/damage_law.hpp"

namespace ixos {

DamageLaw::DamageLaw(double stiffness, double strength, double range, bool bonds_on_touch)
    : PiecewiseLaw({{strength / stiffness, 0, {0, -stiffness, 0, 0}},
                    {range, range, {0, strength / (range - strength / stiffness), 0, 0}}},
                   range / 2, strength / stiffness),
      stiffness_(stiffness),
      softening_(strength / (range - strength / stiffness)),
      bonds_on_touch_(bonds_on_touch) {}

FrozenDamage::FrozenDamage(const DamageLaw& law, const Pack& kappa) {
  const Pack zero = 0.0, end = law.range();
  const Pack room = select(kappa < end, Pack(end - kappa), zero), peak = law.softening() * room;
  const Pack stored = 0.5 * peak * kappa;
  pieces_[0] = {-std::numeric_limits<double>::infinity(), zero, zero, -law.stiffness_of_bond(), zero};
  pieces_[1] = {zero, zero, zero, -peak / kappa, zero};
  pieces_[2] = {kappa, kappa, -peak, law.softening(), stored};
  pieces_[3] = {kappa + room, kappa + room, zero, zero, stored + 0.5 * peak * room};
}

Pack FrozenDamage::mean_traction(const Pack& r0, const Pack& r1) const {
  Pack sum = 0.0;
  for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) {
    const PathPart<Pack> part(pieces_[i].low, high(i), r0, r1);
    sum += 0.5 * (part.end - part.start) * (pieces_[i].at(part.from) + pieces_[i].at(part.to));
  }
  return sum;
}

Pack FrozenDamage::mean_stiffness(const Pack& r0, const Pack& r1) const {
  Pack sum = 0.0;
  for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) {
    const PathPart<Pack> part(pieces_[i].low, high(i), r0, r1);
    sum -= 0.5 * pieces_[i].slope * (part.end - part.start) * (part.end + part.start);
  }
  return sum;
}

Pack FrozenDamage::mean_potential(const Pack& r0, const Pack& r1) const {
  const Pack at_start = energy(r0);
  Pack sum = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const PathPart<Pack> part(pieces_[i].low, high(i), r0, r1);
    for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
      const TractionPiece piece{
          high(i)[lane], pieces_[i].start[lane], {pieces_[i].traction[lane], pieces_[i].slope[lane], 0, 0}};
      double here = sum[lane];
      add_mean_potential(piece, pieces_[i].energy[lane], at_start[lane], r0[lane], part.from[lane], part.to[lane],
                         here);
      sum[lane] = here;
    }
  }
  return sum;
}

}  // namespace ixos
