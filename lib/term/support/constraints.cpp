#include "term/support/constraints.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/error.hpp"

namespace ixos {
namespace {

const char* const across_plane = "a condition moves a node across a plane that another one keeps it in";

/// In place of a motion's number: the degree of freedom is entrusted to what is no node's.
constexpr auto entrusted_motion = static_cast<std::size_t>(-1);

bool is_motion(const MotionShare& share) { return share.motion != nullptr; }

/// Without a motion the factor does not matter: both are held at zero.
bool are_same(const MotionShare& a, const MotionShare& b) {
  return a.motion == b.motion && (a.motion == nullptr || a.factor == b.factor);
}

}  // namespace

void Constraints::check(int dof, double factor, const std::shared_ptr<const TimeFunction>& motion) const {
  check(dof, {{factor, motion}});
}

void Constraints::check(int dof, const std::vector<MotionShare>& shares) const {
  if (dimension_ > 0 && std::any_of(shares.begin(), shares.end(), is_motion))
    for (const Vec<3>& normal : planes_.normals(dof / static_cast<int>(dimension_)))
      if (std::abs(normal[dof_index(dof) % dimension_]) > 1e-9) throw InputError(across_plane);
  if (holds(dof) && !holds_by(dof, shares))
    throw InputError("two conditions prescribe different motions for one degree of freedom");
}

std::vector<MotionShare> Constraints::shares(int dof) const {
  std::vector<MotionShare> all;
  if (!holds(dof)) return all;
  for (auto k = static_cast<std::size_t>(index_[dof_index(dof)]); k < entries_.size() && entries_[k].dof == dof; ++k)
    if (entries_[k].motion != entrusted_motion) all.push_back({entries_[k].factor, motions_[entries_[k].motion]});
  return all;
}

bool Constraints::holds_by(int dof, const std::vector<MotionShare>& shares) const {
  if (!holds(dof)) return false;
  const std::vector<MotionShare> known = this->shares(dof);  // none if it is entrusted
  const std::vector<MotionShare> held{{0.0, nullptr}};
  const std::vector<MotionShare>& wanted = shares.empty() ? held : shares;
  return std::equal(known.begin(), known.end(), wanted.begin(), wanted.end(), are_same);
}

void Constraints::add(int dof, double factor, const std::shared_ptr<const TimeFunction>& motion) {
  add(dof, {{factor, motion}});
}

void Constraints::refuse_closed() const {
  if (closed_)
    throw std::logic_error("a constraint is added after an integrator or an evaluator was made of the model");
}

void Constraints::add(int dof, const std::vector<MotionShare>& shares) {
  refuse_closed();
  check(dof, shares);
  if (holds(dof)) return;
  if (index_.size() <= dof_index(dof)) index_.resize(dof_index(dof) + 1, -1);
  index_[dof_index(dof)] = static_cast<int>(entries_.size());
  dofs_.push_back(dof);
  prescribed_.push_back(dof);
  if (dimension_ > 0) planes_.hold(dof / static_cast<int>(dimension_), dof_index(dof) % dimension_);
  if (shares.empty()) return push(dof, 0.0, nullptr);
  for (const auto& [factor, motion] : shares) push(dof, factor, motion);
}

void Constraints::entrust(int dof) {
  refuse_closed();
  const bool in_plane = dimension_ > 0 && !planes_.normals(dof / static_cast<int>(dimension_)).empty();
  if (holds(dof) || in_plane)
    throw InputError("a condition holds or moves a degree of freedom that a rigid body carries");
  if (index_.size() <= dof_index(dof)) index_.resize(dof_index(dof) + 1, -1);
  index_[dof_index(dof)] = static_cast<int>(entries_.size());
  entries_.push_back({dof, entrusted_motion, 0.0});
  dofs_.push_back(dof);
  entrusted_.push_back(dof);
}

bool Constraints::moves(int dof) const {
  if (!holds(dof)) return false;
  for (auto k = static_cast<std::size_t>(index_[dof_index(dof)]); k < entries_.size() && entries_[k].dof == dof; ++k)
    if (entries_[k].motion == entrusted_motion || motions_[entries_[k].motion] != nullptr) return true;
  return false;
}

bool Constraints::holds_in_plane(int node, std::size_t dimension, const Vec<3>& normal) const {
  Vec<3> left = 1 / length(normal) * normal;
  for (std::size_t i = 0; i < dimension; ++i)
    if (holds_by(node * static_cast<int>(dimension) + static_cast<int>(i), {})) left[i] = 0;
  for (const Vec<3>& own : planes_.normals(node)) left = left - inner(own, left) * own;
  return length(left) < 1e-4;
}

void Constraints::check_plane(int node, std::size_t dimension, const Vec<3>& normal) const {
  for (std::size_t i = 0; i < dimension; ++i)
    if (std::abs(normal[i]) > 1e-9 * length(normal) && moves(node * static_cast<int>(dimension) + static_cast<int>(i)))
      throw InputError(across_plane);
}

void Constraints::hold_in_plane(int node, std::size_t dimension, const Vec<3>& normal) {
  refuse_closed();
  check_plane(node, dimension, normal);
  dimension_ = dimension;
  planes_.add(node, dimension, normal);
  for (std::size_t i = 0; i < dimension; ++i)
    if (holds(node * static_cast<int>(dimension) + static_cast<int>(i))) planes_.hold(node, i);
}

void Constraints::push(int dof, double factor, const std::shared_ptr<const TimeFunction>& motion) {
  auto found = std::find(motions_.begin(), motions_.end(), motion);
  if (found == motions_.end()) found = motions_.insert(found, motion);
  entries_.push_back({dof, static_cast<std::size_t>(found - motions_.begin()), factor});
  driven_ = driven_ || motion != nullptr;
}

void Constraints::set(double time, double* u, double* v, double* a) const {
  std::vector<TimeValue> values;
  values.reserve(motions_.size());
  for (const auto& motion : motions_) values.push_back(motion ? motion->at(time) : TimeValue{});
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const auto& [dof, motion, factor] = entries_[k];
    if (motion == entrusted_motion) continue;
    const TimeValue& value = values[motion];
    const bool first = k == 0 || entries_[k - 1].dof != dof;
    const auto put = [first, i = dof_index(dof)](double* x, double part) {
      if (x != nullptr) x[i] = first ? part : x[i] + part;
    };
    put(u, factor * value.value);
    put(v, factor * value.rate);
    put(a, factor * value.acceleration);
  }
}

bool Constraints::are_finite(double time) const {
  return std::all_of(motions_.begin(), motions_.end(), [time](const auto& motion) {
    const TimeValue f = motion ? motion->at(time) : TimeValue{};
    return std::isfinite(f.value) && std::isfinite(f.rate) && std::isfinite(f.acceleration);
  });
}

}  // namespace ixos
