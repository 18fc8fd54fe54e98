#include "scene/read/driving.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"
#include "mesh/fitted_normal.hpp"
#include "mesh/selection.hpp"
#include "scene/read/grips.hpp"
#include "scene/read/initial_conditions.hpp"

namespace ixos {
namespace {

using Point = std::array<double, 3>;
using Axes = std::array<bool, 3>;

constexpr int most_steps = 100000;

/// Longer arrays are refused elsewhere.
Point point(const std::vector<double>& x) {
  Point result{};
  std::copy_n(x.begin(), std::min<std::size_t>(x.size(), 3), result.begin());
  return result;
}

std::vector<double> times_of(const StepControlOptions& control) {
  const double duration = control.final_time - control.initial_time;
  const double steps = std::ceil(duration / control.time_step * (1 - 1e-9));
  const double step = control.adaptive.on ? duration / 1000 : control.time_step;
  const auto count = static_cast<int>(control.adaptive.on ? 1000 : std::min<double>(steps, most_steps));
  std::vector<double> times{control.initial_time};
  for (int k = 1; k <= count; ++k) times.push_back(std::min(control.initial_time + k * step, control.final_time));
  if (times.back() < control.final_time) times.push_back(control.final_time);
  return times;
}

Point without(Point x, const Axes& axes) {
  for (std::size_t i = 0; i < 3; ++i)
    if (axes[i]) x[i] = 0;
  return x;
}

/// Returns whether the normal is so near to the axes that a body cannot leave the obstacle without moving along them.
bool spans(const Axes& axes, const Point& normal) {
  const Point rest = without(normal, axes);
  return dot(rest, rest) < 0.01;
}

/// Returns the length of the part of x along which a body that is held along some axes can move and keep its gap.
double sliding(const Point& x, const Point& normal, const Axes& held) {
  const Point free = without(x, held), rest = without(normal, held);
  const double across = spans(held, normal) ? 0 : dot(free, rest) * dot(free, rest) / dot(rest, rest);
  return std::sqrt(std::max(0.0, dot(free, free) - across));
}

Axes axes_of(const std::map<int, Axes>& by_part, int part) {
  const auto found = by_part.find(part);
  return found == by_part.end() ? Axes{} : found->second;
}

template <class Set>
const Set* find(const std::vector<Set>& sets, const std::string& name) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
  return found == sets.end() ? nullptr : &*found;
}

/// Returns the axis along the normal of a plane of symmetry, as "x"; empty if there is none.
std::string axis_across(const SceneNode& node, const Mesh& mesh) {
  const NodeSet* const set = find_set(mesh.node_sets, node.text("Node Set"));
  if (set == nullptr) return "";
  const Vec<3> normal = at(node.path_of("Node Set"), [&] { return fitted_normal(mesh, *set); });
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(normal[i]) > 1 - 1e-9) return std::string(1, "xyz"[i]);
  return "";
}

}  // namespace

Driving::Driving(const SceneNode& scene, const Histories& histories, const StepControlOptions& control,
                 const Mesh& mesh, const std::vector<int>& parts)
    : times_(times_of(control)), fixed_(!control.adaptive.on), dimension_(mesh.dimension), part_of_node_(parts) {
  const SceneNode initial = scene.sublist("Initial Conditions");
  for (const InitialMotion& motion : initial_motions(initial, mesh.dimension, mesh.axisymmetric)) {
    moves_ = moves_ || motion.has_gradient();
    for (const ElementBlock& block : mesh.blocks) {
      const bool named = std::count(motion.blocks.begin(), motion.blocks.end(), block.name) > 0;
      for (int cell = 0; cell < block.cells() && (named || motion.blocks.empty()); ++cell)
        velocities_[parts[static_cast<std::size_t>(block.nodes[cell_entry(cell, nodes_per_cell(block.type))])]] =
            motion.velocity;
    }
  }
  for (const SceneNode& node : scene.sublist("Boundary Conditions").sublists()) {
    if (node.text("Type") == "Displacement")
      add_motion(node, node.text("Components"), node.text("History"), histories, parts_of(node, mesh));
    else if (node.text("Type") == "Symmetry")
      add_motion(node, axis_across(node, mesh), "", histories, parts_of(node, mesh));
    else
      add_load(node, histories, mesh);
  }
  for (const SceneNode& node : scene.sublist("Grips").sublists()) add_grip(node, histories, mesh);
  // A body of revolution cannot leave its axis.
  if (mesh.axisymmetric)
    for (int part : parts) prescribed_[part][0] = held_[part][0] = true;
}

/// Returns the connected parts on which a condition acts.
std::set<int> Driving::parts_of(const SceneNode& node, const Mesh& mesh) const {
  std::set<int> parts;
  const auto add = [&](int number) { parts.insert(part_of_node_[static_cast<std::size_t>(number)]); };
  const auto add_cell = [&](const ElementBlock& block, int cell) {
    add(block.nodes[cell_entry(cell, nodes_per_cell(block.type))]);
  };
  if (const NodeSet* set = find(mesh.node_sets, node.text("Node Set")); set != nullptr) {
    for (int number : set->nodes) add(number);
  } else if (const SideSet* sides = find(mesh.side_sets, node.text("Side Set")); sides != nullptr) {
    for (const Side& side : sides->sides) add_cell(mesh.blocks[static_cast<std::size_t>(side.block)], side.cell);
  } else {
    const std::string& name = node.text("Block");
    for (const ElementBlock& block : mesh.blocks)
      for (int cell = 0; cell < block.cells() && (name.empty() || name == block.name); ++cell) add_cell(block, cell);
  }
  return parts;
}

/// A rotation has no one direction, and springs leave open how far the body follows.
void Driving::add_grip(const SceneNode& node, const Histories& histories, const Mesh& mesh) {
  const GripOptions grip = read_grip(node);
  const std::set<int> parts = parts_of(node, mesh);
  if (grip.type == GripType::Springs) {
    moves_ = moves_ || !grip.histories().empty();
    return;
  }
  if (!grip.rotation.empty()) moves_ = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.dimension); ++i) {
    const std::string history = grip.along(i);
    if (history.empty() && !grip.rotation.empty())
      for (int part : parts) prescribed_[part][i] = true;
    else
      add_motion(node, std::string(1, "xyz"[i]), history, histories, parts);
  }
}

void Driving::add_motion(const SceneNode& node, const std::string& along, const std::string& name,
                         const Histories& histories, const std::set<int>& parts) {
  const std::string components = along != "all" ? along : dimension_ == 2 ? "xy" : "xyz";
  const auto mark = [&](std::map<int, Axes>& axes) {
    for (int part : parts)
      for (char component : components) axes[part][static_cast<std::size_t>(component - 'x')] = true;
  };
  mark(prescribed_);
  if (name.empty()) return mark(held_);
  if (histories.is_given(name)) {  // its future is unknown
    moves_ = true;
    return;
  }
  const TimeFunction& function = *histories.get(name, HistoryUse::Motion);
  Action& way = ways_[node.text("Node Set")];
  if (way.path.empty()) way = {node.path(), parts, std::vector<Point>(times_.size(), Point{})};
  const std::vector<TimeValue> samples = sampled(function);
  const TimeValue& first = samples.front();
  Motion motion = measured(node.path(), samples);
  motion.start = first.value;
  for (char component : components) {
    const auto i = static_cast<std::size_t>(component - 'x');
    for (const int part : parts)
      motion.start_jump = std::max(motion.start_jump, std::abs(first.rate - velocity_of(part)[i]));
    for (std::size_t k = 0; k < times_.size(); ++k) way.values[k][i] += samples[k].value - first.value;
  }
  if (motion.range == 0) mark(held_);
  motions_.push_back(motion);
}

std::vector<TimeValue> Driving::sampled(const TimeFunction& function) const {
  std::vector<TimeValue> samples;
  for (double time : times_) samples.push_back(function.at(time));
  return samples;
}

/// Leaves out what happens at the initial time.
Motion Driving::measured(const std::string& path, const std::vector<TimeValue>& samples) const {
  Motion motion;
  motion.path = path;
  double lowest = samples.front().value, highest = lowest;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const TimeValue &before = samples[k - 1], &now = samples[k];
    lowest = std::min(lowest, now.value);
    highest = std::max(highest, now.value);
    if (k > most_steps) continue;  // the last interval of a very long run is longer than a step
    if (fixed_) motion.in_one_step = std::max(motion.in_one_step, std::abs(now.value - before.value));
    // The accelerations at both ends explain the rest of the change.
    const double smooth = (before.acceleration + now.acceleration) / 2 * (times_[k] - times_[k - 1]);
    if (const double jump = std::abs(now.rate - before.rate - smooth); jump > motion.velocity_jump) {
      motion.velocity_jump = jump;
      motion.jump_time = times_[k];
    }
  }
  motion.range = highest - lowest;
  return motion;
}

void Driving::add_obstacle(const SceneNode& node, const MotionOptions& obstacle, const Histories& histories) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension_); ++i)
    if (const std::string name = obstacle.along(i); !name.empty() && !histories.is_given(name))
      motions_.push_back(measured(node.path(), sampled(*histories.get(name, HistoryUse::Motion))));
}

void Driving::add_load(const SceneNode& node, const Histories& histories, const Mesh& mesh) {
  const Point vector = point(node.numbers("Vector"));
  const std::string& name = node.text("History");
  Action load{node.path(), parts_of(node, mesh), {}};
  if (name.empty()) {
    load.values.push_back(vector);
  } else if (histories.is_given(name)) {
    load.values.push_back({});  // of unknown size
  } else {
    const TimeFunction& function = *histories.get(name, HistoryUse::Load);  // which also checks it
    for (double time : times_) {
      const double factor = function.at(time).value;
      load.values.push_back({factor * vector[0], factor * vector[1], factor * vector[2]});
    }
  }
  loads_.push_back(std::move(load));
}

Driving::Point Driving::velocity_of(int part) const {
  const auto found = velocities_.find(part);
  return found == velocities_.end() ? Point{} : found->second;
}

Drive Driving::of_part(int part, const Point& normal) const {
  const Axes held = axes_of(held_, part);
  const auto pull = [&](const Action& action) {
    Pull result{action.path, 0, 0, 0};
    for (const Point& value : action.values) {
      result.away = std::max(result.away, dot(value, normal));
      result.towards = std::max(result.towards, -dot(value, normal));
      result.along = std::max(result.along, sliding(value, normal, held));
    }
    return result;
  };
  Drive drive;
  drive.held = spans(axes_of(prescribed_, part), normal);
  drive.approach = std::max(0.0, -dot(velocity_of(part), normal) * (times_.back() - times_.front()));
  for (const auto& [set, way] : ways_) {
    if (way.parts.count(part) == 0) continue;
    drive.pulls.push_back(pull(way));
    drive.approach = std::max(drive.approach, drive.pulls.back().towards);
  }
  for (const Action& load : loads_)
    if (load.parts.count(part) > 0) drive.pulls.push_back(pull(load));
  return drive;
}

}  // namespace ixos
