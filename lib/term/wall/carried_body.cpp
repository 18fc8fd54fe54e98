#include "term/wall/carried_body.hpp"

#include <algorithm>
#include <experimental/simd>

#include "rigid/cayley.hpp"

namespace ixos {
namespace {

/// The numbers that belong to the freedoms of a body, T first; in the plane T_x, T_y and w_z. The last ones are idle.
template <std::size_t D>
using Freedoms = std::experimental::fixed_size_simd<double, D == 2 ? 4 : 8>;

constexpr auto unaligned = std::experimental::element_aligned;

/// Returns the place of the body's number i among them.
std::size_t lane(std::size_t i, std::size_t dimension) {
  return dimension == 2 && i >= RigidBody::turning ? i - RigidBody::turning : i;
}

}  // namespace

CarriedBody::CarriedBody(const MovingFrame& frame)
    : frame_(frame),
      body_(*frame.motion().body()),
      lanes_(frame.dimension() == 2 ? Freedoms<2>::size() : Freedoms<3>::size()),
      block_(lanes_ * lanes_) {
  const std::size_t nodes = frame.nodes().size();
  for (std::vector<double>* const array : {&columns_, &rows_}) array->resize(nodes * frame.dimension() * lanes_);
  parts_.resize(3 * columns_.size());
  for (std::vector<Triple>* const arms : {&sight_.arms, &sight_.ends}) arms->resize(nodes);
}

const SurfaceSight& CarriedBody::at(const RigidPose& pose, const RulePoint& point, const std::vector<double>& seen) {
  sight_.body = BodySight::at(pose.turn, pose.step, point.to);
  sight_.share = point.to;
  for (std::size_t n = 0; n < sight_.arms.size(); ++n) sight_.arms[n] = frame_.arm(pose, frame_.nodes()[n], seen);
  return sight_;
}

const SurfaceSight& CarriedBody::between(const RigidPose& start, const RigidPose& end, const std::vector<double>& from,
                                         const std::vector<double>& to) {
  sight_.body = BodySight::between(start.turn, end.turn, end.step);
  sight_.share = 0.5;
  for (std::size_t n = 0; n < sight_.arms.size(); ++n) {
    const MovingFrame::Node& node = frame_.nodes()[n];
    sight_.ends[n] = frame_.arm(end, node, to);
    sight_.arms[n] = scaled(0.5, sum(frame_.arm(start, node, from), sight_.ends[n]));
  }
  return sight_;
}

void CarriedBody::subtract(const Triple& force, const Triple& turning, double* f) const {
  double* const numbers = f + frame_.motion().first();
  for (std::size_t i = 0; i < 3; ++i) numbers[i] -= force[i];
  if (!body_.turns()) return;
  for (std::size_t i = 0; i < 3; ++i) numbers[RigidBody::turning + i] -= turning[i] / body_.length();
}

void CarriedBody::add_force(const SurfaceSight& sight, const std::vector<double>& g, double* f) const {
  Triple force{}, moment{};
  for (std::size_t n = 0; n < frame_.nodes().size(); ++n) {
    const MovingFrame::Node& node = frame_.nodes()[n];
    if (!node.owned) continue;
    const Triple own = turned(sight.body.forces(), frame_.vector_at(node, g.data()));
    if (!node.derivative) force = sum(force, own);
    moment = sum(moment, cross(sight.arms[n], own));
  }
  subtract(force, sight.body.to_rotation(moment), f);
}

void CarriedBody::add_force(const RigidPose& pose, const std::vector<double>& seen, const std::vector<double>& g,
                            double* f) const {
  Triple force{}, moment{};
  for (const MovingFrame::Node& node : frame_.nodes()) {
    if (!node.owned) continue;
    const Triple own = frame_.vector_at(node, g.data());
    if (!node.derivative) force = sum(force, own);
    if (!body_.turns()) continue;
    const Triple place = sum(node.place, frame_.vector_at(node, seen.data()));
    moment = sum(moment, cross(node.derivative ? place : sum(place, pose.point, -1), own));
  }
  subtract(turned(pose.turn, force), cayley_force(pose.step, moment), f);
}

void CarriedBody::see_change(const RigidPose& pose, double factor, const double* direction,
                             const std::vector<double>& seen, std::vector<double>& change) const {
  const double* const numbers = direction + frame_.motion().first();
  const Triple way = turned_back(pose.turn, RigidBody::triple(numbers));
  const Triple spin = cayley_spin(pose.step, body_.rotation(numbers));
  for (const MovingFrame::Node& node : frame_.nodes()) {
    const Triple arm = turned_back(pose.turn, frame_.arm(pose, node, seen));
    const Triple own = sum(node.derivative ? Triple{} : way, cross(spin, arm));
    for (std::size_t i = 0; i < frame_.dimension(); ++i) change[node.first + i] -= factor * own[i];
  }
}

void CarriedBody::gather(const std::vector<double>& g, CarriedForces& forces) const {
  forces.clear();
  for (const MovingFrame::Node& node : frame_.nodes()) forces.push_back(frame_.vector_at(node, g.data()));
}

void CarriedBody::clear() {
  for (std::vector<double>* const array : {&columns_, &rows_, &block_}) std::fill(array->begin(), array->end(), 0.0);
}

/// Nodes see the body's motion as their own the other way: -K times the motion, besides the turning of the forces.
template <std::size_t D>
void CarriedBody::add_border_of(const SurfaceSight& sight, const CarriedForces& g, std::vector<double>& own,
                                double* values) {
  using Pack = Freedoms<D>;
  constexpr std::size_t lanes = Pack::size(), array = D * lanes, axis = D == 2 ? 2 : 0;
  const auto load = [](const double* from) { return Pack(from, unaligned); };
  const std::vector<MovingFrame::Node>& nodes = frame_.nodes();
  const bool turns = body_.turns();
  const Small<double, 3> rows = turns ? sight.body.matrix() : Small<double, 3>{};  // L
  std::array<Triple, 3> spins{};
  for (std::size_t k = axis; k < 3 && turns; ++k) spins[k] = sight.body.turning(k);
  // By node: how it moves with the body's freedoms, how forces on it act on them, and its columns.
  std::fill(parts_.begin(), parts_.end(), 0.0);
  Triple force{}, moment{};  // of the nodes that this rank counts
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    double *const motions = &parts_[3 * n * array], *const moments = motions + array, *const columns = moments + array;
    for (std::size_t i = 0; i < D && !nodes[n].derivative; ++i) motions[i * lanes + i] = moments[i * lanes + i] = 1;
    const Triple in_space = turned(sight.body.forces(), g[n]);
    if (nodes[n].owned && !nodes[n].derivative) force = sum(force, in_space);
    if (!turns) continue;
    const Triple turning = sight.body.is_mean() ? scaled(0.5, turned(sight.body.pose(), g[n])) : in_space;
    const Triple &arm = sight.arms[n], &end = sight.body.is_mean() ? sight.ends[n] : arm;
    if (nodes[n].owned) moment = sum(moment, cross(arm, in_space));
    for (std::size_t k = axis; k < 3; ++k) {
      // (L (a x f))_k = f . (L_k x a), L_k the k-th row of L; its derivative by the arm is f x L_k.
      const Triple motion = cross(spins[k], end), column = cross(spins[k], turning), by_force = cross(rows[k], arm),
                   by_arm = cross(in_space, rows[k]);
      const std::size_t place = D + k - axis;
      for (std::size_t i = 0; i < D; ++i) {
        motions[i * lanes + place] = motion[i] / sight.body.to();
        columns[i * lanes + place] = column[i];
        moments[i * lanes + place] = by_force[i];
        if (nodes[n].owned) rows_[n * array + i * lanes + place] -= sight.share * by_arm[i];
      }
    }
  }
  const Small<double, 3> left = rotation_matrix(sight.body.forces()), right = rotation_matrix(sight.body.pose());
  for (const MovingFrame::Block& block : frame_.blocks()) {
    const double* const motions = &parts_[3 * block.column * array];
    const double* const moments = &parts_[(3 * block.row + 1) * array];
    double *const columns = &parts_[(3 * block.row + 2) * array], *const row = &rows_[block.column * array];
    double* const seen = &own[block.first];
    const Small<double, D> value = turned_block<D>(left, seen, block.stride, right);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        if (values != nullptr) values[block.first + i * block.stride + j] += value[i][j];
        seen[i * block.stride + j] = 0;
      }
    for (std::size_t i = 0; i < D; ++i) {
      Pack sum = load(columns + i * lanes);
      for (std::size_t j = 0; j < D; ++j) sum -= value[i][j] * load(motions + j * lanes);
      sum.copy_to(columns + i * lanes, unaligned);
    }
    if (!nodes[block.row].owned) continue;
    for (std::size_t j = 0; j < D; ++j) {
      Pack sum = load(row + j * lanes);
      for (std::size_t i = 0; i < D; ++i) sum -= value[i][j] * load(moments + i * lanes);
      sum.copy_to(row + j * lanes, unaligned);
    }
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const double *const moments = &parts_[(3 * n + 1) * array], *const columns = moments + array;
    for (std::size_t i = 0; i < D; ++i) {
      const Pack column = load(columns + i * lanes);
      double* const all = &columns_[n * array + i * lanes];
      (load(all) + column).copy_to(all, unaligned);
      if (!nodes[n].owned) continue;
      for (std::size_t k = 0; k < lanes; ++k)
        (load(&block_[k * lanes]) - moments[i * lanes + k] * column).copy_to(&block_[k * lanes], unaligned);
    }
  }
  for (std::size_t k = 0; k < RigidBody::attitude && turns; ++k) {
    const bool is_way = k < RigidBody::turning;
    if (is_way ? k >= D : k - RigidBody::turning < axis) continue;
    const Triple change = is_way ? scaled(-sight.share, sight.body.to_rotation(cross(basis_vector(k), force)))
                                 : sight.body.to_rotation_by(k - RigidBody::turning, moment);
    for (std::size_t i = axis; i < 3; ++i) block_[(D + i - axis) * lanes + lane(k, D)] -= change[i];
  }
}

void CarriedBody::add_border(const SurfaceSight& sight, const CarriedForces& g, std::vector<double>& own,
                             double* values) {
  if (frame_.dimension() == 2)
    add_border_of<2>(sight, g, own, values);
  else
    add_border_of<3>(sight, g, own, values);
}

void CarriedBody::add_to(Border& border) const {
  const std::size_t first = frame_.motion().first() - border.first_global(), d = frame_.dimension();
  const auto scale = [&](std::size_t k) { return k < RigidBody::turning ? 1 : 1 / body_.length(); };
  for (const std::size_t k : body_.free()) {
    std::vector<double>&column = border.column(first + k), &row = border.row(first + k);
    std::size_t place = lane(k, d);
    for (const MovingFrame::Node& node : frame_.nodes())
      for (std::size_t i = node.first; i < node.first + d; ++i, place += lanes_) {
        column[i] += scale(k) * columns_[place];
        row[i] += scale(k) * rows_[place];
      }
    for (const std::size_t i : body_.free())
      border.entry(first + i, first + k) += scale(i) * scale(k) * block_[lane(i, d) * lanes_ + lane(k, d)];
  }
}

}  // namespace ixos
