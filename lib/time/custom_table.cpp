#include "time/custom_table.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <stdexcept>

#include "parameters/one_of.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Numbers = Teuchos::Array<double>;

/// One stage's entries, with its name for messages.
class StageReader {
 public:
  StageReader(const List& list, std::size_t known_states) : list_(list), known_(known_states) {}

  Stage read() const {
    Stage stage;
    stage.end = list_.get<double>("End");
    stage.velocity = row("Velocity");
    stage.acceleration = row("Acceleration");
    stage.inertia = given("Inertia") ? row("Inertia") : stage.acceleration;
    stage.damping = given("Damping") ? row("Damping") : stage.velocity;
    const Path path = list_.get<std::string>("Path") == "Linear" ? Path::Linear : Path::Kinematic;
    stage.elastic = rule("Elastic Points", "Elastic Weights", Path::Linear);
    const bool exact = list_.get<std::string>("Interaction Mean") == "Exact";
    if (exact && path != Path::Linear) fail("Interaction Mean", "the exact mean needs the linear path");
    stage.interaction = exact ? exact_rule() : rule("Interaction Points", "Interaction Weights", path);
    stage.load = load(stage.end);
    if (!(stage.inertia.unknown > 0))
      fail("Inertia", "the coefficient of the unknown must be greater than 0: only implicit stages are allowed");
    if (stage.elastic.points.empty())
      fail("Elastic Points", "one point must be greater than 0: only implicit stages are allowed");
    return stage;
  }

 private:
  [[noreturn]] void fail(const char* entry, const std::string& what) const {
    const std::string& path = list_.name();  // of Teuchos: "Scene->...->Stages->First"
    const std::size_t arrow = path.rfind("->");
    throw std::invalid_argument(
        fmt::format("stage \"{}\", {}: {}", arrow == std::string::npos ? path : path.substr(arrow + 2), entry, what));
  }
  const Numbers& numbers(const char* name) const { return list_.get<Numbers>(name); }
  bool given(const char* name) const { return !numbers(name).empty(); }

  Row row(const char* name) const {
    const Numbers& values = numbers(name);
    const auto size = static_cast<std::size_t>(values.size());
    if (size % 3 != 1 || size > 1 + 3 * known_)
      fail(name,
           fmt::format("it has {} numbers; a row has one for the unknown and three for each known state, at most {}",
                       size, 1 + 3 * known_));
    Row result;
    result.unknown = values[0];
    for (int k = 1; k < values.size(); k += 3) result.known.push_back({values[k], values[k + 1], values[k + 2]});
    return result;
  }

  Rule rule(const char* points, const char* weights, Path path) const {
    const Numbers& xi = numbers(points);
    const Numbers& w = numbers(weights);
    if (xi.size() != w.size() || xi.empty())
      fail(weights,
           fmt::format("there are {} weights for {} points; their numbers must be equal", w.size(), xi.size()));
    return point_rule({xi.begin(), xi.end()}, {w.begin(), w.end()}, path);
  }

  std::vector<TimePoint> load(double end) const {
    if (!given("Load Times")) return {{end, 1.0}};
    const Numbers& times = numbers("Load Times");
    const Numbers& weights = numbers("Load Weights");
    if (times.size() != weights.size())
      fail("Load Weights",
           fmt::format("there are {} weights for {} times; their numbers must be equal", weights.size(), times.size()));
    std::vector<TimePoint> result;
    result.reserve(static_cast<std::size_t>(times.size()));
    for (int k = 0; k < times.size(); ++k) result.push_back({times[k], weights[k]});
    return result;
  }

  const List& list_;
  std::size_t known_;
};

/// Chooses the form of rates: Middle for one stage in momentum form, whose damping row is du, and otherwise the force
/// at the ends.
void set_rates(Table& table) {
  for (Stage& stage : table.stages) stage.rate_start = stage.elastic.kept_weight;
  Stage& stage = table.stages.front();
  const Row& row = stage.damping;
  const bool from_start = row.known.size() == 1 && row.known[0].u == -1 && row.known[0].v == 0 && row.known[0].a == 0;
  if (table.stages.size() > 1 || table.work.form != WorkSum::Form::Increment || row.unknown != 1 || !from_start) return;
  stage.rate_form = RateForm::Middle;
  stage.rate_start = 0;
}

}  // namespace

List custom_parameters() {
  List list;
  list.set("Closing", "Kinematic",
           "Acceleration at the end of the step. Kinematic takes it from the last stage's row; Collocate solves the "
           "balance of forces for it.",
           one_of({"Kinematic", "Collocate"}));
  list.set("Driven Rates", "Exact",
           "Velocity and acceleration of driven degrees of freedom if Closing is Kinematic. Exact takes those of the "
           "motion, Own those of the rows.",
           one_of({"Exact", "Own"}));
  list.set("Work", "Increment",
           "How the work of external and damping forces is summed (docs/theory.md, Energy balance).",
           one_of({"Increment", "End Mean", "Stages"}));
  list.set("Work Weights", Numbers(), "Weights of the step's start and of each stage's end, if Work is Stages.",
           any_number());
  list.set("Error Constant", 0.0, "Local error of a displacement over dt^3 u''', for adaptive steps [-]. 0: not known.",
           any_number());
  List& stage = list.sublist("Stages", false, "The stages of a step, in order.").sublist(any_name);
  stage.set("End", 1.0, "Time of the stage's unknown u_s, as a fraction of the step [-].", greater_than(0));
  stage.set("Velocity", Numbers(),
            "Row of dt v: the coefficients {s, p0, q0, r0, p1, ...} of u_s, u_0, dt v_0, dt^2 a_0, u_1, ... State 0 is "
            "the step's start, state 1 the first stage's end, and so on.",
            any_number());
  stage.set("Acceleration", Numbers(), "Row of dt^2 a, in the order of Velocity.", any_number());
  stage.set("Inertia", Numbers(),
            "Row of dt^2 times the vector that the mass matrix multiplies. If empty, it is Acceleration.",
            any_number());
  stage.set("Damping", Numbers(),
            "Row of dt times the vector that the damping matrix multiplies. If empty, it is Velocity.", any_number());
  stage.set("Elastic Points", Numbers(1, 1.0),
            "Points on the path from the step's start (0) to u_s (1) at which elastic forces are taken.",
            between(0, 1));
  stage.set("Elastic Weights", Numbers(1, 1.0), "Weights of Elastic Points. They must sum to 1.", any_number());
  stage.set("Interaction Points", Numbers(1, 1.0), "Points on that path at which interaction forces are taken.",
            between(0, 1));
  stage.set("Interaction Weights", Numbers(1, 1.0), "Weights of Interaction Points. They must sum to 1.", any_number());
  stage.set("Interaction Mean", "Points",
            "Mean of the interaction. Points takes Interaction Points; Exact takes the exact mean over the linear "
            "path, in closed form.",
            one_of({"Points", "Exact"}));
  stage.set("Path", "Linear", "Path of the displacement on which interaction forces are taken.",
            one_of({"Linear", "Kinematic"}));
  stage.set("Load Times", Numbers(),
            "Times at which external forces are taken, as fractions of the step. If empty, it is End.", any_number());
  stage.set("Load Weights", Numbers(), "Weights of Load Times. They must sum to 1.", any_number());
  return list;
}

Table custom_table(const List& list) {
  Table table;
  table.name = "Custom";
  const List& stages = list.sublist("Stages");
  for (const auto& [name, entry] : entries(stages))
    table.stages.push_back(StageReader(stages.sublist(name), table.stages.size() + 1).read());
  if (table.stages.empty()) throw std::invalid_argument("Stages is empty; a scheme needs at least one stage");
  if (table.stages.size() == 1) table.predictor = Predictor::Nearest;
  table.closing = list.get<std::string>("Closing") == "Kinematic" ? Closing::Kinematic : Closing::Collocate;
  table.driven_rates = list.get<std::string>("Driven Rates") == "Exact" ? DrivenRates::Exact : DrivenRates::Own;
  table.error_constant = list.get<double>("Error Constant");
  const auto work = list.get<std::string>("Work");
  table.work.form = work == "Increment"  ? WorkSum::Form::Increment
                    : work == "End Mean" ? WorkSum::Form::EndMean
                                         : WorkSum::Form::Stages;
  const Numbers& weights = list.get<Numbers>("Work Weights");
  table.work.weights.assign(weights.begin(), weights.end());
  set_rates(table);
  return table;
}

}  // namespace ixos
