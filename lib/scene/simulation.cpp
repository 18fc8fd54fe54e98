#include "scene/simulation.hpp"

#include <fmt/format.h>

#include <Teuchos_Time.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/phase_timer.hpp"
#include "mesh/connected_parts.hpp"
#include "mesh/fingerprint.hpp"
#include "mesh/name_pattern.hpp"
#include "mesh/partition.hpp"
#include "mesh/refinement.hpp"
#include "model/set_reactions.hpp"
#include "scene/examine/compatibility.hpp"
#include "scene/examine/mesh_inspection.hpp"
#include "scene/examine/notes.hpp"
#include "scene/examine/scene_facts.hpp"
#include "scene/examine/supports.hpp"
#include "scene/examine/symmetry.hpp"
#include "scene/examine/warnings.hpp"
#include "scene/history_columns.hpp"
#include "scene/output/output_fields.hpp"
#include "scene/output/output_norms.hpp"
#include "scene/read/conditions.hpp"
#include "scene/read/grips.hpp"
#include "scene/read/histories.hpp"
#include "scene/read/initial_conditions.hpp"
#include "scene/read/interactions.hpp"
#include "scene/read/materials.hpp"
#include "scene/read/maxwell_branches.hpp"
#include "scene/read/mesh_adaptation.hpp"
#include "scene/read/mesh_refinement.hpp"
#include "scene/read/mesh_sets.hpp"
#include "scene/read/newton_options.hpp"
#include "scene/read/obstacle_files.hpp"
#include "scene/read/rigid_bodies.hpp"
#include "scene/read/rigid_body_loads.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/read/scene_units.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "solve/choice/problem_size.hpp"
#include "time/catalogue.hpp"
#include "time/default_linear_solver.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

/// Times are doubles: at 1e12 they are 1e-4 apart. A step or an interval has to be much longer than that.
void check_resolution(const StepControlOptions& control, const std::string& path, double interval) {
  const double coarsest = std::max(std::abs(control.initial_time), std::abs(control.final_time));
  const double least = 200 * std::numeric_limits<double>::epsilon() * coarsest;
  if (interval < least)
    throw InputError(fmt::format("{}: {} is lost in rounding against the times {} to {}: it must be at least {:.3g}",
                                 path, interval, control.initial_time, control.final_time, least));
}

/// Returns the scene with what its files are for.
List with_files(const List& scene, const std::string& folder) {
  return with_branch_files(with_obstacle_files(scene, folder), folder);
}

std::vector<std::string> interaction_names(const List& scene) {
  std::vector<std::string> names;
  for (const SceneNode& node : SceneNode(scene, "").sublist("Interactions").sublists()) names.push_back(node.name());
  return names;
}

/// Returns the columns of a run with this simulation alone.
std::vector<std::string> columns_of_run(const Simulation& simulation) {
  std::vector<std::string> columns = history_columns(simulation).names;
  if (simulation.model().mass() == nullptr) columns.emplace_back(released_column);
  if (simulation.adaptation().on()) columns.emplace_back(adapted_column);
  return columns;
}

}  // namespace

Simulation::Simulation(const List& scene, const Comm& comm, const std::string& folder, const GivenHistories& given)
    : Simulation(std::make_shared<Plan>(Plan{Stages(scene, given),
                                             [folder](const List& list) { return with_files(list, folder); },
                                             [folder](List& list, bool bubbles, const Splitting& splitting) {
                                               return scene_mesh(list, folder, bubbles, splitting);
                                             },
                                             [folder](const List& list) { prepare_drawings(list, folder); }, given}),
                 comm, {}) {}

Simulation::Simulation(const List& scene, const Mesh& mesh, const Comm& comm, const GivenHistories& given)
    : Simulation(std::make_shared<Plan>(given_mesh_plan(scene, mesh, given)), comm, {}) {}

/// Only later stages, and meshes that change, need the mesh after the constructor.
Simulation::Plan Simulation::given_mesh_plan(const List& scene, const Mesh& mesh, const GivenHistories& given) {
  Stages stages(scene, given);
  const bool changes = scene.isSublist("Mesh") && scene.sublist("Mesh").isSublist("Adapt");
  const auto kept = stages.any() || changes ? std::make_shared<const Mesh>(mesh) : std::shared_ptr<const Mesh>();
  const Mesh* own = kept ? kept.get() : &mesh;
  return {std::move(stages),
          [d = mesh.dimension, axisymmetric = mesh.axisymmetric](const List& list) {
            return with_given_mesh(with_files(list, "."), d, axisymmetric);
          },
          [kept, own](List& list, bool bubbles, const Splitting& splitting) {
            return scene_mesh(list, *own, bubbles, splitting);
          },
          [](const List&) {}, given};
}

Simulation::Simulation(std::shared_ptr<Plan> plan, const Comm& comm, std::vector<double> begins,
                       const CellSplits* splits)
    : plan_(std::move(plan)),
      begins_(std::move(begins)),
      parameters_(complete_scene(plan_->with_files(plan_->stages.scene(begins_)))),
      units_(scene_units(parameters_)),
      output_(read_output(SceneNode(parameters_, "").sublist("Output"), interaction_names(parameters_))),
      time_integrator_(read_time_integrator(SceneNode(parameters_, "").sublist("Time Integrator"), output_)),
      newton_(read_newton(SceneNode(parameters_, "").sublist("Nonlinear Solver"))) {
  Teuchos::Time timer("setup", true);
  const StepControlOptions& control = step_control();
  planned_end_ = control.final_time;
  if (!(control.final_time > control.initial_time))
    throw InputError(fmt::format("Time Integrator/Time Step Control/Final Time: {} must be later than Initial Time, {}",
                                 control.final_time, control.initial_time));
  check_resolution(control, "Time Integrator/Time Step Control/Time Step", control.time_step);
  check_resolution(control, "Time Integrator/Time Step Control/Final Time less Initial Time",
                   control.final_time - control.initial_time);
  if (const double interval = output_.history_time_interval; interval > 0)
    check_resolution(control, "Output/History Time Interval", interval);
  if (const double interval = output_.fields_time_interval; interval > 0)
    check_resolution(control, "Output/Fields Time Interval", interval);
  Table table = chosen_table();
  const SceneNode scene_node(parameters_, "");
  materials_ = read_materials(scene_node.sublist("Materials"));
  interactions_ = read_interactions(scene_node.sublist("Interactions"));
  check_compatibility(scene_node, materials_, interactions_, control.adaptive, table);
  adaptation_ = read_adaptation(scene_node, interactions_);
  if (adaptation_.on() && !scene_node.sublist("Rigid Bodies").sublists().empty())
    throw InputError("Mesh/Adapt: rigid bodies do not pass from mesh to mesh yet; leave Adapt or Rigid Bodies out");
  build_model(comm, table.mass, splits);
  build_integrator(std::move(table));
  if (stage() == 0 && splits == nullptr)
    set_initial_state();
  else
    integrator_->await_state(control.initial_time);
  if (stages().any() && stage() == 0 && splits == nullptr) {
    planned_end_ = stages().planned_ends().back();
    look_ahead();
  }
  if (stages().any()) stop_criteria();  // refuses those that the stage cannot have
  setup_seconds_ = timer.stop();
}

/// Builds the later stages, as if each came to its end, for what their scenes say: messages, warnings and columns.
void Simulation::look_ahead() {
  std::unique_ptr<Simulation> next;
  std::set<std::string> known(notes_.begin(), notes_.end());
  for (const Warning& warning : warnings_) known.insert(warning.message);
  for (const Simulation* stage = this; stage->has_next_stage(); stage = next.get()) {
    const std::size_t number = stage->stage() + 1;
    at(stages().path(number), [&] {
      auto built = stage->next_stage(stage->step_control().final_time);
      stage->refuse_jump_to(*built);
      next = std::move(built);
    });
    next->resumes();
    for (const Warning& warning : next->warnings())
      if (known.insert(warning.message).second)
        warnings_.push_back({warning.name, placed(stages().path(number), warning.message)});
    for (const std::string& note : next->notes())
      if (known.insert(note).second) notes_.push_back(placed(stages().path(number), note));
    std::vector<std::string>& all = plan_->columns;
    for (const std::string& column : columns_of_run(*next))
      if (std::find(all.begin(), all.end(), column) == all.end()) all.push_back(column);
  }
}

/// Throws InputError if a prescribed displacement of both stages would jump between them.
void Simulation::refuse_jump_to(const Simulation& next) const {
  const Constraints &mine = model_->constraints(), &others = next.model().constraints();
  // Ghosts may be others: the ranks' own degrees of freedom are the same.
  std::vector<double> before(static_cast<std::size_t>(model_->space().local()), 0.0),
      after(static_cast<std::size_t>(next.model().space().local()), 0.0);
  const double time = next.step_control().initial_time;
  mine.set(time, before.data(), nullptr, nullptr);
  others.set(time, after.data(), nullptr, nullptr);
  double jump = 0, largest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_->space().owned()); ++i) {
    const int dof = static_cast<int>(i);
    if (!mine.holds(dof) || !others.holds(dof)) continue;
    jump = std::max(jump, std::abs(after[i] - before[i]));
    largest = std::max({largest, std::abs(before[i]), std::abs(after[i])});
  }
  jump = model_->space().maximum(jump);
  if (jump > 1e-6 * model_->space().maximum(largest))
    throw InputError(fmt::format(
        "Boundary Conditions: a prescribed displacement would jump by {:.3g} L0 at t = {:.6g} T0", jump, time));
}

std::unique_ptr<Simulation> Simulation::next_stage(double begin) const {
  if (!has_next_stage()) throw std::logic_error("the scene has no further stage");
  std::vector<double> begins = begins_;
  begins.push_back(begin);
  CellSplits splits;
  if (split_mesh_) splits = split_mesh_->tree().splits();
  plan_->owner = owner_;
  plan_->mesh = mesh_fingerprint_;
  std::unique_ptr<Simulation> next(
      new Simulation(plan_, model_->space().comm(), std::move(begins), split_mesh_ ? &splits : nullptr));
  next->setup_seconds_ += setup_seconds_;                                 // of all so far
  next->planned_end_ = planned_end_ + begin - step_control().final_time;  // a stage may end early
  return next;
}

std::unique_ptr<Simulation> Simulation::on_mesh(const CellSplits& splits) const {
  plan_->owner.clear();
  plan_->mesh.clear();
  std::unique_ptr<Simulation> next(new Simulation(plan_, model_->space().comm(), begins_, &splits));
  next->setup_seconds_ += setup_seconds_;
  next->planned_end_ = planned_end_;
  return next;
}

std::string Simulation::fingerprint_of_results() const {
  return split_mesh_ ? fingerprint(split_mesh_->base()) : mesh_fingerprint_;
}

const SplitMesh& Simulation::split_mesh() const {
  if (!split_mesh_) throw std::logic_error("the mesh of the scene stays as it is");
  return *split_mesh_;
}

std::vector<NamedRegion> Simulation::refined_places() const {
  return refined_regions(SceneNode(parameters_, "").sublist("Mesh").sublist("Refine"));
}

void Simulation::resumes() {
  warnings_.erase(std::remove_if(warnings_.begin(), warnings_.end(), is_about_start), warnings_.end());
}

StopCriteria Simulation::stop_criteria() const {
  return {SceneNode(parameters_, "").sublist("Time Integrator").sublist("Stop"), probes_, *model_};
}

Table Simulation::chosen_table() const {
  const Scheme& chosen = scheme(time_integrator_.scheme);
  try {
    Table table = chosen.table(parameters_.sublist("Time Integrator").sublist(chosen.name));
    if (time_integrator_.predictor) table.predictor = *time_integrator_.predictor;
    check(table);
    return table;
  } catch (const std::invalid_argument& error) {
    throw InputError("Time Integrator/" + chosen.name + ": " + error.what());
  }
}

std::vector<int> Simulation::partition(const Mesh& mesh, int ranks, Inertia inertia) const {
  // A restart in a later stage, on the mesh of its checkpoint, has to find the division that an earlier stage chose.
  if (ranks == 1 || (stages().any() && adaptation_.on())) return partition_nodes(mesh, ranks);
  std::vector<std::string> contact;
  for (const SceneInteraction& interaction : interactions_) contact.push_back(interaction.side_set);
  const FacingNodes facing = facing_nodes(interactions_, mesh);
  // An explicit step solves nothing; of an implicit one the residual is a few per cent.
  const int solve = inertia == Inertia::Lumped ? 0 : 500;
  return partition_nodes(mesh, ranks, node_work(mesh, contact, solve, facing.sides), facing.pairs);
}

LocalMesh Simulation::local_mesh(const Mesh& mesh, const std::vector<int>& owner, int rank, int ranks,
                                 Inertia inertia) const {
  LocalMesh local = localize(mesh, owner, rank, ranks, whole_side_sets(interactions_));
  const long long dofs = static_cast<long long>(mesh.nodes()) * mesh.dimension;
  if (inertia != Inertia::Lumped &&
      may_use_coarse_cells(parameters_.sublist("Linear Solver"), mesh.dimension, dofs, ranks))
    add_coarse_cells(mesh, owner, rank, ranks, local);
  return local;
}

/// All stages have one mesh.
bool Simulation::some_stage_needs_bubbles() const {
  if (needs_bubbles(parameters_)) return true;
  if (!stages().any()) return false;
  const std::vector<double> ends = stages().planned_ends(begins_);
  std::vector<double> begins;
  for (std::size_t stage = 0; stage < stages().count(); ++stage) {
    if (needs_bubbles(stages().scene(begins))) return true;
    begins.push_back(ends[stage]);
  }
  return false;
}

/// Makes the mesh, and enriches its surfaces. May throw on some ranks only.
Mesh Simulation::whole_mesh(const CellSplits* splits, Inertia inertia) {
  Mesh base;
  SplitTree tree;
  Splitting splitting;
  if (adaptation_.on()) splitting = {{}, splits, &base, &tree};
  Mesh mesh = plan_->make_mesh(parameters_.sublist("Mesh"), inertia == Inertia::Lumped || some_stage_needs_bubbles(),
                               splitting);
  add_pattern_sets(set_patterns(parameters_), mesh);
  std::vector<std::string> sets;
  for (const NodeSet& set : mesh.node_sets) sets.push_back(set.name);
  output_.reactions = expanded(output_.reactions, sets);
  for (std::string& message : inspect_mesh(SceneNode(parameters_, ""), mesh))
    warnings_.push_back({"mesh", std::move(message)});
  if (std::string note = size_note(parameters_.sublist("Mesh"), mesh, units_); !note.empty())
    mesh.notes.push_back(std::move(note));
  set_sizes_ = ixos::set_sizes(mesh);
  read_factor_fields(interactions_, parameters_.sublist("Mesh"), mesh);
  enrich_surfaces(interactions_, mesh);
  check_adaptation(adaptation_, interactions_, mesh);
  if (adaptation_.on()) split_mesh_ = std::make_unique<const SplitMesh>(std::move(base), mesh, std::move(tree));
  return mesh;
}

void Simulation::build_model(const Comm& comm, Inertia inertia, const CellSplits* splits) {
  const NamedScope scope("mesh and model");
  Mesh mesh;
  on_first_rank(comm, [&] { plan_->prepare(parameters_.sublist("Mesh")); });
  together<InputError>(comm, [&] { mesh = whole_mesh(splits, inertia); });
  notes_ = mesh.notes;
  result_units_ = ixos::result_units(units_, mesh.body_dimension());
  std::vector<double> files = nodal_factors(interactions_);
  const std::vector<double> sums = obstacle_file_checksums(parameters_);
  files.insert(files.end(), sums.begin(), sums.end());
  mesh_fingerprint_ = fingerprint(mesh, files);
  together<InputError>(comm, [&, first = from_first_rank(comm, mesh_fingerprint_)] {
    if (mesh_fingerprint_ != first)
      throw InputError("the ranks read different meshes: all must see the same files, and the same cache of meshes");
  });
  if (!plan_->mesh.empty() && plan_->mesh != mesh_fingerprint_)
    throw InputError(
        "the mesh is another one than that of the stage before: all stages need the same contact elements on the same "
        "surfaces, the same mesh and the same Factor Fields");
  mesh_quality_ = ixos::mesh_quality(mesh);
  const std::vector<int> parts = connected_parts(mesh);
  numbers_ = ixos::characteristic_numbers(SceneNode(parameters_, ""), materials_, interactions_, mesh, parts);
  if (std::string bad = quality_warning(mesh_quality_); !bad.empty())
    warnings_.push_back({"mesh quality", std::move(bad)});
  const int ranks = comm->getSize();
  // Stages on one mesh have one partition: states are handed over rank by rank.
  const std::vector<int> owner = plan_->owner.empty() ? partition(mesh, ranks, inertia) : plan_->owner;
  if (stages().any()) owner_ = owner;
  const SceneNode scene(parameters_, "");
  RigidBodies bodies =
      read_rigid_bodies(scene.sublist("Rigid Bodies"), mesh.dimension, mesh.axisymmetric, inertia != Inertia::None);
  model_ = at("Materials", [&] {
    return std::make_unique<Model>(local_mesh(mesh, owner, comm->getRank(), ranks, inertia), comm, materials_, inertia,
                                   std::move(bodies));
  });
  const StepControlOptions& control = step_control();
  const Histories histories(scene.sublist("Histories"), control.initial_time, control.final_time, plan_->given,
                            inertia == Inertia::None);
  // A body at rest may be in the way of an obstacle that has moved by now: the state that a later stage is given
  // counts.
  const bool is_start = stage() == 0 && splits == nullptr;
  const double start = is_start ? control.initial_time : std::numeric_limits<double>::quiet_NaN();
  add_interactions(interactions_, scene.sublist("Rigid Bodies"), histories, start, *model_);
  add_conditions(scene.sublist("Boundary Conditions"), histories, *model_);
  add_grips(scene.sublist("Grips"), scene.sublist("Rigid Bodies"), histories, *model_);
  add_rigid_body_loads(scene.sublist("Rigid Bodies"), histories, *model_);
  at("Boundary Conditions", [&] { model_->check_tied_conditions(); });
  refuse_unused_histories(scene, interactions_, histories);
  if (!has_next_stage())
    for (std::string& note : histories.notes()) notes_.push_back(std::move(note));
  SceneFacts facts = scene_facts(scene, numbers_, materials_, interactions_, mesh, parts, histories, control, inertia);
  facts.scales = Scales{units_.si("L0"), units_.si("E0"), units_.si("T0")};
  for (Warning& warning : scene_warnings(facts))
    if (!adaptation_.on() || warning.name != "cohesive zone") warnings_.push_back(std::move(warning));
  hints_ = scene_notes(facts);
  if (inertia == Inertia::None)
    for (Warning& found : missing_supports(scene, interactions_, mesh, parts)) warnings_.push_back(std::move(found));
  probes_ = find_probes(scene.sublist("Output").sublist("Probes"), *model_);
  const std::vector<std::string>& recorded = output_.reactions;
  for (const std::string& name : recorded) {
    if (std::count(recorded.begin(), recorded.end(), name) > 1)
      throw InputError("Output/Reactions: the node set \"" + name + "\" is given twice");
    at("Output/Reactions", [&] {
      model_->mesh().node_set(name);
      if (!stages().any()) check_held(*model_, name);  // a stage may let go
    });
  }
  chosen_fields(output_.fields, *model_);                          // refuses those that the model does not have
  norm_fields(output_.norms, *model_);                             // the same
  const std::vector<std::string> columns = columns_of_run(*this);  // refuses names that make no columns
  if (plan_->columns.empty()) plan_->columns = columns;
}

void Simulation::build_integrator(Table table) {
  const NamedScope scope("solver set-up");
  const SceneNode scene(parameters_, "");
  const StepControlOptions& control = step_control();
  const double longest = control.adaptive.on ? control.maximum_step : control.time_step;
  const ProblemSize size{model_->mesh().dimension,
                         model_->space().global(),
                         model_->space().comm()->getSize(),
                         asymmetry(scene, materials_, *model_, table),
                         matrix_only(scene, materials_, model_->mesh()),
                         model_->mesh().level_width,
                         mesh_quality_.largest_aspect_ratio,
                         tangent_stiffness(*model_, table, longest),
                         has_quadratic_cells(model_->mesh()),
                         model_->mesh().refinement != nullptr,
                         term_without_coarse(*model_)};
  const bool restartable = output_.checkpoint.keep > 0;
  List& linear = parameters_.sublist("Linear Solver");
  linear = completed_linear_solver(linear, size);
  // An explicit step has no tangent; its stable length asks for the damping's matrix.
  if (linear.get<std::string>("Operator") == "Matrix-Free" && !is_explicit(table)) model_->do_without_matrices();
  integrator_ = std::make_unique<Integrator>(
      *model_, std::move(table), std::make_shared<LinearSolverFactory>(linear, model_.get(), restartable), newton_);
  integrator_->keep_static_rates(time_integrator_.keeps_static_rates);
}

std::vector<double> Simulation::given_velocities() const {
  const LocalMesh& mesh = model_->mesh();
  const SceneNode initial = SceneNode(parameters_, "").sublist("Initial Conditions");
  std::vector<double> v =
      initial_velocities(initial_motions(initial, mesh.dimension, mesh.axisymmetric), *model_, materials_);
  set_rigid_body_velocities(SceneNode(parameters_, "").sublist("Rigid Bodies"), *model_, v);
  return v;
}

void Simulation::set_initial_state() {
  std::vector<double> v = given_velocities();
  std::vector<double> u(v.size(), 0.0);
  const double time = step_control().initial_time;
  at("Initial Conditions", [&] { integrator_->initialize(std::move(u), std::move(v), time); });
}

}  // namespace ixos
