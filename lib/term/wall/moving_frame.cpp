#include "term/wall/moving_frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/small_matrix.hpp"
#include "base/turn.hpp"

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

}  // namespace

MovingFrame::MovingFrame(FrameMotion motion, const LocalMesh& mesh, const std::vector<LocalSide>& sides,
                         const Pattern& pattern)
    : motion_(std::move(motion)), d_(static_cast<std::size_t>(mesh.dimension)) {
  std::vector<int> numbers;
  for (const LocalSide& side : sides) numbers.insert(numbers.end(), side.nodes.begin(), side.nodes.end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (const int number : numbers) {
    const auto n = static_cast<std::size_t>(number);
    nodes_.push_back({n * d_, mesh.owns(number), mesh.is_derivative(n), {}});
    nodes_.back().place = vector_at(nodes_.back(), mesh.coordinates.data());
  }
  place(pattern);
}

void MovingFrame::place(const Pattern& pattern) {
  blocks_.clear();
  if (!turns() && motion_.body() == nullptr) return;
  std::vector<int> numbers;
  for (const Node& node : nodes_) numbers.push_back(static_cast<int>(node.first / d_));
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const int row = numbers[k];
    if (!pattern.has_row(row)) continue;
    pattern.for_each_block(row, [&](int column, int offset) {
      const auto found = std::lower_bound(numbers.begin(), numbers.end(), column);
      if (found == numbers.end() || *found != column) return;
      blocks_.push_back({static_cast<std::size_t>(offset), static_cast<std::size_t>(pattern.stride(row)), k,
                         static_cast<std::size_t>(found - numbers.begin())});
    });
  }
}

Triple MovingFrame::arm(const RigidPose& pose, const Node& node, const std::vector<double>& seen) const {
  const Triple place = sum(node.place, vector_at(node, seen.data()));
  return turned(pose.turn, node.derivative ? place : sum(place, pose.point, -1));
}

template <std::size_t D, class Displacement>
void MovingFrame::see_nodes_of(const RigidPose& pose, const Displacement& u, std::vector<double>& seen) const {
  const bool turning = turns();
  const Turn turn = pose.turn;
  for (const Node& node : nodes_) {
    const double mean = node.derivative ? 0 : 1;  // derivatives are not translated
    std::array<double, D> own, arm;
    for (std::size_t i = 0; i < D; ++i) {
      own[i] = u(node.first + i) - mean * pose.translation[i];
      arm[i] = own[i] + node.place[i] - mean * pose.point[i];
    }
    for (std::size_t i = 0; i < D && turning; ++i)
      for (std::size_t j = 0; j < D; ++j) own[j] += turn[i][j] * arm[i];
    std::copy(own.begin(), own.end(), seen.begin() + static_cast<std::ptrdiff_t>(node.first));
  }
}

template <class Displacement>
void MovingFrame::see_nodes(const RigidPose& pose, const Displacement& u, std::vector<double>& seen) const {
  if (d_ == 2)
    see_nodes_of<2>(pose, u, seen);
  else
    see_nodes_of<3>(pose, u, seen);
}

void MovingFrame::see(const RigidPose& pose, const Segment& segment, const RulePoint& point,
                      std::vector<double>& seen) const {
  const double to = point.to, from = point.from, velocity = point.velocity;
  const double *const end = segment.to, *const start = segment.from, *const way = segment.velocity;
  // The end is always given, the others if their factor is not 0.
  if (velocity != 0)
    see_nodes(
        pose, [=](std::size_t i) { return to * end[i] + (from != 0 ? from * start[i] : 0) + velocity * way[i]; }, seen);
  else if (from != 0)
    see_nodes(
        pose, [=](std::size_t i) { return to * end[i] + from * start[i]; }, seen);
  else
    see_nodes(
        pose, [=](std::size_t i) { return to * end[i]; }, seen);
}

void MovingFrame::see(const RigidPose& pose, const double* u, std::vector<double>& seen) const {
  see_nodes(
      pose, [u](std::size_t i) { return u[i]; }, seen);
}

void MovingFrame::see_change(const RigidPose& pose, double factor, const double* du, std::vector<double>& seen) const {
  for (const Node& node : nodes_) {
    Triple change = vector_at(node, du);
    if (turns()) change = turned_back(pose.turn, change);
    set(scaled(factor, change), &seen[node.first]);
  }
}

void MovingFrame::add_moved(const Turn& turn, std::vector<double>& f, double* total) const {
  for (const Node& node : nodes_) {
    Triple force = vector_at(node, f.data());
    if (turns()) force = turned(turn, force);
    add(force, total + node.first);
    set({}, &f[node.first]);
  }
}

/// Adds sum_k factor(R_ik) values_k to the sums, without rotation the values themselves, and clears the values.
template <class Factor>
void MovingFrame::add_turned(const RigidPose& pose, const Factor& factor, std::vector<double>& values,
                             double* sums) const {
  const Small<double, 3> r = rotation_matrix(pose.turn);
  for (const Node& node : nodes_)
    for (std::size_t i = 0; i < d_; ++i)
      for (std::size_t k = 0; k < d_; ++k)
        sums[node.first + i] += (turns() ? factor(r[i][k]) : r[i][k]) * values[node.first + k];
  clear(values);
}

void MovingFrame::add_row_sums(const RigidPose& pose, std::vector<double>& sums, double* all) const {
  // sum_j |(R K R^T)_ij| <= sum_k |R_ik| sum_l |K_kl| sum_j |R_jl|, and the last sum is at most sqrt(d).
  const double bound = std::sqrt(static_cast<double>(d_));
  add_turned(
      pose, [bound](double r) { return bound * std::abs(r); }, sums, all);
}

void MovingFrame::add_diagonal(const RigidPose& pose, std::vector<double>& diagonal, double* all) const {
  add_turned(
      pose, [](double r) { return r * r; }, diagonal, all);
}

/// Replaces V by L V R^T.
template <std::size_t D>
void MovingFrame::turn_blocks_of(const Small<double, 3>& l, const Small<double, 3>& r, double* values) const {
  for (const Block& block : blocks_) {
    const Small<double, D> value = turned_block<D>(l, values + block.first, block.stride, r);
    for (std::size_t i = 0; i < D; ++i) std::copy_n(value[i].begin(), D, values + block.first + i * block.stride);
  }
}

void MovingFrame::turn_blocks(const Turn& left, const Turn& right, bool back, double* values) const {
  const auto matrix = [back](const Turn& turn) {
    const Small<double, 3> m = rotation_matrix(turn);
    Small<double, 3> transposed;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) transposed[i][j] = m[j][i];
    return back ? m : transposed;
  };
  if (d_ == 2)
    turn_blocks_of<2>(matrix(left), matrix(right), values);
  else
    turn_blocks_of<3>(matrix(left), matrix(right), values);
}

void MovingFrame::add_moved_matrix(const RigidPose& pose, const Pattern& pattern, const std::vector<double>& seen,
                                   double* values) {
  const Small<double, 3> r = rotation_matrix(pose.turn);
  const auto d = static_cast<std::size_t>(pattern.dimension());
  for (int row = 0; row < pattern.rows(); ++row) {
    const auto n = static_cast<std::size_t>(row), stride = static_cast<std::size_t>(pattern.stride(row));
    for (int entry = pattern.row_start()[n]; entry < pattern.row_start()[n + 1]; ++entry) {
      const auto first =
          static_cast<std::size_t>(pattern.offset(row, pattern.columns()[static_cast<std::size_t>(entry)]));
      for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j)
          for (std::size_t k = 0; k < d; ++k)
            for (std::size_t l = 0; l < d; ++l)
              values[first + i * stride + j] += r[i][k] * seen[first + k * stride + l] * r[j][l];
    }
  }
}

void MovingFrame::subtract_product(const Pattern& pattern, const std::vector<double>& values,
                                   const std::vector<double>& x, std::vector<double>& y) const {
  for (const Node& node : nodes_) {
    const int row = static_cast<int>(node.first / d_);
    if (!pattern.has_row(row)) continue;
    const auto stride = static_cast<std::size_t>(pattern.stride(row));
    pattern.for_each_block(row, [&](int column, int offset) {
      for (std::size_t i = 0; i < d_; ++i)
        for (std::size_t j = 0; j < d_; ++j)
          y[node.first + i] -=
              values[static_cast<std::size_t>(offset) + stride * i + j] * x[static_cast<std::size_t>(column) * d_ + j];
    });
  }
}

Triple MovingFrame::from_frame(const RigidPose& pose, const Triple& y) {
  return sum(sum(y, times(pose.turn, sum(y, pose.point, -1))), pose.translation);
}

double MovingFrame::power(const RigidPose& pose, const std::vector<double>& f, const std::vector<double>& seen) const {
  const Triple velocity = turned_back(pose.turn, pose.velocity);
  double result = 0;
  for (const Node& node : nodes_) {
    if (!node.owned) continue;
    const Triple force = vector_at(node, f.data());
    if (!node.derivative) result += dot(force, velocity);
    if (pose.spin == 0) continue;
    const Triple place = sum(node.place, vector_at(node, seen.data()));
    const Triple arm = node.derivative ? place : sum(place, pose.point, -1);
    const Triple way = cross(pose.axis, arm);
    for (std::size_t i = 0; i < 3; ++i) result += force[i] * pose.spin * way[i];
  }
  return result;
}

void MovingFrame::see_velocity(const RigidPose& pose, const std::vector<double>& seen,
                               std::vector<double>& velocity) const {
  const Triple translation = turned_back(pose.turn, pose.velocity);
  for (const Node& node : nodes_) {
    const Triple place = sum(node.place, vector_at(node, seen.data()));
    const Triple arm = node.derivative ? place : sum(place, pose.point, -1);
    const Triple here = sum(node.derivative ? Triple{} : translation, cross(pose.axis, arm), pose.spin);
    set(here, &velocity[node.first]);
  }
}

void MovingFrame::add_turning_rate(const RigidPose& pose, const std::vector<double>& f, double* total) const {
  if (pose.spin == 0) return;
  for (const Node& node : nodes_) {
    const Triple rate = cross(pose.axis, turned(pose.turn, vector_at(node, f.data())));
    add(scaled(pose.spin, rate), total + node.first);
  }
}

double MovingFrame::work(const Turn& turn, const std::vector<double>& f, const std::vector<double>& seen0,
                         const std::vector<double>& seen1, const double* u0, const double* u1) const {
  double result = 0;
  for (const Node& node : nodes_) {
    if (!node.owned) continue;
    const Triple change = sum(vector_at(node, seen1.data()), vector_at(node, seen0.data()), -1);
    const Triple way = sum(vector_at(node, u1), vector_at(node, u0), -1);
    result += dot(vector_at(node, f.data()), sum(change, turned_back(turn, way), -1));
  }
  return result;
}

void MovingFrame::clear(std::vector<double>& array) const {
  for (const Node& node : nodes_) set({}, &array[node.first]);
}

}  // namespace ixos
