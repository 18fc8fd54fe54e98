#include "term/wall/carried_body.hpp"

#include "rigid/cayley.hpp"

namespace ixos {

SurfaceSight CarriedBody::at(const RigidPose& pose, const RulePoint& point, const std::vector<double>& seen) const {
  SurfaceSight sight{BodySight::at(pose.turn, pose.step, point.to), point.to};
  for (const MovingFrame::Node& node : frame_.nodes()) sight.arms.push_back(frame_.arm(pose, node, seen));
  return sight;
}

SurfaceSight CarriedBody::between(const RigidPose& start, const RigidPose& end, const std::vector<double>& from,
                                  const std::vector<double>& to) const {
  SurfaceSight sight{BodySight::between(start.turn, end.turn, end.step), 0.5};
  for (const MovingFrame::Node& node : frame_.nodes()) {
    sight.ends.push_back(frame_.arm(end, node, to));
    sight.arms.push_back(scaled(0.5, sum(frame_.arm(start, node, from), sight.ends.back())));
  }
  return sight;
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

void CarriedBody::clear() {
  columns_.assign(frame_.nodes().size(), {});
  rows_.assign(frame_.nodes().size(), {});
  block_ = {};
}

/// Nodes see the body's motion as their own the other way: -K times the motion, besides the turning of the forces.
void CarriedBody::add_border(const SurfaceSight& sight, const std::vector<double>& g,
                             const std::vector<double>& values) {
  const std::vector<MovingFrame::Node>& nodes = frame_.nodes();
  const std::vector<std::size_t>& free = body_.free();
  const std::size_t d = frame_.dimension();
  std::array<Triple, 3> spins{};
  const Small<double, 3> rows = sight.body.matrix();  // L
  for (const std::size_t k : free)
    if (k >= RigidBody::turning) spins[k - RigidBody::turning] = sight.body.turning(k - RigidBody::turning);
  parts_.resize(nodes.size());
  Triple force{}, moment{};  // of the nodes that this rank counts
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    Part& part = parts_[n];
    const Triple own = frame_.vector_at(nodes[n], g.data()), in_space = turned(sight.body.forces(), own);
    const Triple turning = sight.body.is_mean() ? scaled(0.5, turned(sight.body.pose(), own)) : in_space;
    const Triple& end = sight.body.is_mean() ? sight.ends[n] : sight.arms[n];
    if (nodes[n].owned) {
      if (!nodes[n].derivative) force = sum(force, in_space);
      moment = sum(moment, cross(sight.arms[n], in_space));
    }
    for (const std::size_t i : free) {
      part.columns[i] = {};
      if (i < RigidBody::turning) {
        part.motions[i] = part.moments[i] = nodes[n].derivative ? Triple{} : basis_vector(i);
        continue;
      }
      const std::size_t k = i - RigidBody::turning;
      part.motions[i] = scaled(1 / sight.body.to(), cross(spins[k], end));
      part.columns[i] = cross(spins[k], turning);
      // (L (a x f))_k = f . (L_k x a), L_k the k-th row of L; its derivative by the arm is f x L_k.
      part.moments[i] = cross(rows[k], sight.arms[n]);
      if (nodes[n].owned) rows_[n][i] = sum(rows_[n][i], cross(in_space, rows[k]), -sight.share);
    }
  }
  for (const MovingFrame::Block& block : frame_.blocks()) {
    const bool counts = nodes[block.row].owned;
    Part &row = parts_[block.row], &column = parts_[block.column];
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = 0; j < d; ++j) {
        const double value = values[block.first + i * block.stride + j];
        for (const std::size_t k : free) {
          row.columns[k][i] -= value * column.motions[k][j];
          if (counts) rows_[block.column][k][j] -= row.moments[k][i] * value;
        }
      }
  }
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (const std::size_t k : free) {
      columns_[n][k] = sum(columns_[n][k], parts_[n].columns[k]);
      if (!nodes[n].owned) continue;
      for (const std::size_t i : free) block_[i][k] -= dot(parts_[n].moments[i], parts_[n].columns[k]);
    }
  if (!body_.turns()) return;
  for (const std::size_t k : free) {
    const Triple change = k < RigidBody::turning
                              ? scaled(-sight.share, sight.body.to_rotation(cross(basis_vector(k), force)))
                              : sight.body.to_rotation_by(k - RigidBody::turning, moment);
    for (std::size_t i = 0; i < 3; ++i) block_[RigidBody::turning + i][k] -= change[i];
  }
}

void CarriedBody::add_to(Border& border) const {
  const std::size_t first = frame_.motion().first() - border.first_global();
  const auto scale = [&](std::size_t k) { return k < 3 ? 1 : 1 / body_.length(); };
  for (const std::size_t k : body_.free()) {
    for (std::size_t n = 0; n < columns_.size(); ++n) {
      const std::size_t place = frame_.nodes()[n].first;
      for (std::size_t i = 0; i < frame_.dimension(); ++i) {
        border.column(first + k)[place + i] += scale(k) * columns_[n][k][i];
        border.row(first + k)[place + i] += scale(k) * rows_[n][k][i];
      }
    }
    for (const std::size_t i : body_.free()) border.entry(first + i, first + k) += scale(i) * scale(k) * block_[i][k];
  }
}

}  // namespace ixos
