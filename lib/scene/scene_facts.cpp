#include "scene/scene_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mesh/layers.hpp"

namespace ixos {
namespace {

using Point = std::array<double, 3>;

double dot(const Point& x, const Point& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

/// Longer arrays are refused elsewhere.
Point point(const std::vector<double>& x) {
  Point result{};
  std::copy_n(x.begin(), std::min<std::size_t>(x.size(), 3), result.begin());
  return result;
}

/// Returns the ends of the first fixed steps, at most 1e5, or 1001 times of an adaptive run.
std::vector<double> times_of(const StepControlOptions& control) {
  constexpr double most = 1e5;
  const double duration = control.final_time - control.initial_time;
  const double steps = std::ceil(duration / control.time_step * (1 - 1e-9));
  const double step = control.adaptive.on ? duration / 1000 : control.time_step;
  const auto count = static_cast<int>(control.adaptive.on ? 1000 : std::min(steps, most));
  std::vector<double> times{control.initial_time};
  for (int k = 1; k <= count; ++k) times.push_back(std::min(control.initial_time + k * step, control.final_time));
  if (times.back() < control.final_time) times.push_back(control.final_time);
  return times;
}

/// The conditions of a scene over its run.
class Conditions {
 public:
  Conditions(const SceneNode& scene, const Histories& histories, const StepControlOptions& control, int dimension)
      : times_(times_of(control)), fixed_(!control.adaptive.on), dimension_(dimension) {
    const SceneNode initial = scene.sublist("Initial Conditions");
    velocity_ = point(initial.numbers("Velocity"));
    for (double value : initial.numbers("Velocity Gradient")) turns_ = turns_ || value != 0;
    for (const SceneNode& node : scene.sublist("Boundary Conditions").sublists()) {
      if (node.text("Type") == "Displacement")
        add_motion(node, histories);
      else
        add_load(node, histories);
    }
  }

  void add_to(SceneFacts& facts) const {
    facts.motions = motions_;
    facts.held = held_;
    facts.loaded = !loads_.empty();
    facts.moves = turns_;
  }

  void add_to(const Point& normal, SurfaceFacts& facts) const {
    const double duration = times_.back() - times_.front();
    facts.approach = std::max(0.0, -dot(velocity_, normal) * duration);
    for (const auto& [set, way] : ways_) {
      facts.pulls.push_back(pull(way.path, way.places, normal));
      for (const Point& x : way.places) facts.approach = std::max(facts.approach, -dot(x, normal));
    }
    for (const auto& [path, forces] : loads_) facts.pulls.push_back(pull(path, forces, normal));
  }

 private:
  struct Way {
    std::string path;
    std::vector<Point> places;  ///< parallel to the times
  };

  static Pull pull(const std::string& path, const std::vector<Point>& values, const Point& normal) {
    Pull result{path, 0, 0};
    for (const Point& value : values) {
      const double away = dot(value, normal);
      result.away = std::max(result.away, away);
      result.along = std::max(result.along, std::sqrt(std::max(0.0, dot(value, value) - away * away)));
    }
    return result;
  }

  void add_motion(const SceneNode& node, const Histories& histories) {
    held_ = true;
    const std::string& name = node.text("History");
    if (name.empty()) return;
    const TimeFunction& function = *histories.get(name, HistoryUse::Motion);
    std::string components = node.text("Components");
    if (components == "all") components = dimension_ == 2 ? "xy" : "xyz";
    Way& way = ways_[node.text("Node Set")];
    if (way.path.empty()) way = {node.path(), std::vector<Point>(times_.size(), Point{})};
    const TimeValue first = function.at(times_.front());
    Motion motion{node.path(), first.value, 0, 0, 0};
    double lowest = first.value, highest = first.value, before = first.value;
    for (std::size_t k = 0; k < times_.size(); ++k) {
      const double value = function.at(times_[k]).value;
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
      // The last interval of a very long run is longer than a step.
      if (fixed_ && k <= 100000) motion.in_one_step = std::max(motion.in_one_step, std::abs(value - before));
      before = value;
      for (char component : components) way.places[k][static_cast<std::size_t>(component - 'x')] += value - first.value;
    }
    for (char component : components)
      motion.start_speed =
          std::max(motion.start_speed, std::abs(first.rate - velocity_[static_cast<std::size_t>(component - 'x')]));
    motion.range = highest - lowest;
    motions_.push_back(motion);
  }

  void add_load(const SceneNode& node, const Histories& histories) {
    const Point vector = point(node.numbers("Vector"));
    const std::string& name = node.text("History");
    std::vector<Point> values;
    for (double time : times_) {
      const double factor = name.empty() ? 1.0 : histories.get(name, HistoryUse::Load)->at(time).value;
      values.push_back({factor * vector[0], factor * vector[1], factor * vector[2]});
      if (name.empty()) break;
    }
    loads_.emplace_back(node.path(), std::move(values));
  }

  std::vector<double> times_;
  bool fixed_;
  int dimension_;
  Point velocity_{};
  bool turns_ = false, held_ = false;
  std::vector<Motion> motions_;
  std::map<std::string, Way> ways_;  ///< by node set
  std::vector<std::pair<std::string, std::vector<Point>>> loads_;
};

int order_of(ContactElement element) {
  if (element == ContactElement::Q1C2) return 2;
  if (element == ContactElement::Q1C4) return 4;
  return element == ContactElement::Q1C1 ? 1 : 3;
}

/// Returns the attraction at a gap; 0 in repulsion and beyond the cutoff.
double attraction(const SceneInteraction& interaction, double gap) {
  if (interaction.cutoff > 0 && gap >= interaction.cutoff) return 0;
  return std::max(0.0, -static_cast<double>(interaction.law->traction(Pack(gap))[0]));
}

}  // namespace

SceneFacts scene_facts(const SceneNode& scene, CharacteristicNumbers numbers, const std::vector<Material>& materials,
                       const std::vector<SceneInteraction>& interactions, const Mesh& mesh, const Histories& histories,
                       const StepControlOptions& control, Inertia inertia) {
  SceneFacts facts;
  const Conditions conditions(scene, histories, control, mesh.dimension);
  conditions.add_to(facts);
  for (const SurfaceNumbers& surface : numbers.surfaces) {
    const auto interaction = std::find_if(interactions.begin(), interactions.end(),
                                          [&](const SceneInteraction& own) { return own.node.name() == surface.name; });
    SurfaceFacts own;
    own.order = order_of(interaction->element);
    own.peak_gap = interaction->law->adhesion_gap();
    conditions.add_to(surface.normal, own);
    const double remaining = std::max(surface.least_gap - own.approach, own.peak_gap);
    own.attraction = attraction(*interaction, remaining);
    const Material& material = materials[numbers.bodies[surface.body].material];
    // Enriched cells stay Standard.
    if (material.formulation != Formulation::Enhanced || own.order > 1) {
      const auto set = std::find_if(mesh.side_sets.begin(), mesh.side_sets.end(),
                                    [&](const SideSet& side_set) { return side_set.name == interaction->side_set; });
      const SingleLayer layer = single_layer(mesh, *set);
      own.single_layer = layer.share;
      own.layer_thickness = layer.thickness;
    }
    facts.surfaces.push_back(std::move(own));
  }
  facts.numbers = std::move(numbers);
  facts.has_inertia = inertia != Inertia::None;
  // Explicit schemes divide the step until it is stable.
  facts.step = control.adaptive.on || inertia == Inertia::Lumped ? 0 : control.time_step;
  facts.duration = control.final_time - control.initial_time;
  return facts;
}

}  // namespace ixos
