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

void MovingFrame::move_blocks(std::vector<double>& own, double* values) const {
  for (const Block& block : blocks_)
    for (std::size_t i = 0; i < d_; ++i)
      for (std::size_t j = 0; j < d_; ++j) {
        double& value = own[block.first + i * block.stride + j];
        if (values != nullptr) values[block.first + i * block.stride + j] += value;
        value = 0;
      }
}

Triple MovingFrame::vector_at(const Node& node, const double* values) const {
  Triple result{};
  std::copy_n(values + node.first, d_, result.begin());
  return result;
}

Triple MovingFrame::seen_from(const RigidPose& pose, const Node& node, Triple u) const {
  if (!node.derivative) u = sum(u, pose.translation, -1);
  if (!turns()) return u;
  const Triple arm = node.derivative ? node.place : sum(node.place, pose.point, -1);
  return sum(turned_back(pose.turn, u), transposed_times(pose.turn, arm));
}

void MovingFrame::see(const RigidPose& pose, const Segment& segment, const RulePoint& point,
                      std::vector<double>& seen) const {
  for (const Node& node : nodes_) {
    Triple u{};
    for (const auto& [factor, array] : {std::pair{point.to, segment.to}, std::pair{point.from, segment.from},
                                        std::pair{point.velocity, segment.velocity}})
      if (factor != 0) u = sum(u, vector_at(node, array), factor);
    std::copy_n(seen_from(pose, node, u).begin(), d_, seen.begin() + static_cast<std::ptrdiff_t>(node.first));
  }
}

void MovingFrame::see(const RigidPose& pose, const double* u, std::vector<double>& seen) const {
  see(pose, {nullptr, nullptr, u}, {1, 0, 0, 1}, seen);
}

void MovingFrame::see_change(const RigidPose& pose, double factor, const double* du, std::vector<double>& seen) const {
  for (const Node& node : nodes_) {
    Triple change = vector_at(node, du);
    if (turns()) change = turned_back(pose.turn, change);
    for (std::size_t i = 0; i < d_; ++i) seen[node.first + i] = factor * change[i];
  }
}

void MovingFrame::add_moved(const Turn& turn, std::vector<double>& f, double* total) const {
  for (const Node& node : nodes_) {
    Triple force = vector_at(node, f.data());
    if (turns()) force = turned(turn, force);
    for (std::size_t i = 0; i < d_; ++i) total[node.first + i] += force[i];
  }
  clear(f);
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

void MovingFrame::turn_blocks(const Turn& left, const Turn& right, bool back, double* values) const {
  const auto matrix = [back](const Turn& turn) {
    const Small<double, 3> m = rotation_matrix(turn);
    Small<double, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) result[i][j] = back ? m[i][j] : m[j][i];
    return result;
  };
  const Small<double, 3> l = matrix(left), r = matrix(right);
  for (const Block& block : blocks_) {
    Small<double, 3> turned_rows{};
    for (std::size_t i = 0; i < d_; ++i)
      for (std::size_t j = 0; j < d_; ++j)
        for (std::size_t k = 0; k < d_; ++k) turned_rows[i][j] += l[i][k] * values[block.first + k * block.stride + j];
    for (std::size_t i = 0; i < d_; ++i)
      for (std::size_t j = 0; j < d_; ++j) {
        double value = 0;
        for (std::size_t k = 0; k < d_; ++k) value += turned_rows[i][k] * r[j][k];
        values[block.first + i * block.stride + j] = value;
      }
  }
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
    std::copy_n(here.begin(), d_, velocity.begin() + static_cast<std::ptrdiff_t>(node.first));
  }
}

void MovingFrame::add_turning_rate(const RigidPose& pose, const std::vector<double>& f, double* total) const {
  if (pose.spin == 0) return;
  for (const Node& node : nodes_) {
    const Triple rate = cross(pose.axis, turned(pose.turn, vector_at(node, f.data())));
    for (std::size_t i = 0; i < d_; ++i) total[node.first + i] += pose.spin * rate[i];
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
  for (const Node& node : nodes_) std::fill_n(array.begin() + static_cast<std::ptrdiff_t>(node.first), d_, 0.0);
}

}  // namespace ixos
