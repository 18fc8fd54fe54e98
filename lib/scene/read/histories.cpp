#include "scene/read/histories.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "histories/catalogue.hpp"
#include "histories/shifted.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

const char* const time_shift = "Time Shift";
const char* const value_shift = "Value Shift";

std::shared_ptr<const TimeFunction> make(const SceneNode& node) {
  auto function = histories().make(node);
  const double time = node.number(time_shift), value = node.number(value_shift);
  return time == 0 && value == 0 ? function : shifted(std::move(function), time, value);
}

}  // namespace

void declare_history(List& list) {
  histories().declare(list);
  list.set(time_shift, 0.0, "Time by which the function is moved [T0]: later, if it is positive.", any_number());
  list.set(value_shift, 0.0, history_value("Number that is added to the value of the function"), any_number());
}

void shift_history(List& list, double time, double value) {
  for (const auto& [name, shift] : {std::pair(time_shift, time), {value_shift, value}}) {
    const bool is_whole = list.isType<int>(name);
    const double before = is_whole ? list.get<int>(name) : list.isParameter(name) ? list.get<double>(name) : 0.0;
    list.set(name, before + shift);
  }
}

double history_at(const SceneNode& list, const GivenHistories& given, const std::string& name, double time) {
  if (const auto found = given.find(name); found != given.end()) return found->second->at(time).value;
  return list.list().isSublist(name) ? make(list.sublist(name))->at(time).value : 0;
}

Histories::Histories(const SceneNode& list, double initial_time, double final_time, const GivenHistories& given,
                     bool statics)
    : given_(given), list_(list), initial_time_(initial_time), final_time_(final_time), statics_(statics) {
  for (const SceneNode& node : list.sublists()) functions_[node.name()] = make(node);
  for (const auto& [name, function] : given) {
    if (function == nullptr) throw InputError("the program gives no function for the history \"" + name + "\"");
    functions_[name] = function;
  }
}

const std::shared_ptr<const TimeFunction>& Histories::get(const std::string& name, HistoryUse use) const {
  const auto found = functions_.find(name);
  if (found == functions_.end()) {
    std::vector<std::string> names;
    for (const auto& [key, function] : functions_) names.push_back(key);
    if (names.empty()) throw InputError("history \"" + name + "\" does not exist; the list Histories is empty");
    throw InputError(no_such("history", name, names, "There are"));
  }
  if (is_given(name)) return found->second;
  const SceneNode own = list_.sublist(name);
  if (use == HistoryUse::Motion && own.text("Type") == "Expression")
    for (const char* derivative : {"Velocity", "Acceleration"})
      if (own.sublist("Expression").text(derivative).empty())
        throw InputError(own.sublist("Expression").path_of(derivative) + " is missing: a motion needs it");
  const TimeFunction& function = *found->second;
  at(own.path(), [&] {
    const double slack = 1e-9 * (function.last_time() - function.first_time());
    if (function.first_time() > initial_time_ + slack || function.last_time() < final_time_ - slack)
      throw InputError(fmt::format("the table covers the times {} to {}, but the run goes from {} to {}",
                                   function.first_time(), function.last_time(), initial_time_, final_time_));
    if (use == HistoryUse::Motion && statics_)
      check_static_over(function, initial_time_, final_time_);
    else
      check_over(function, initial_time_, final_time_, use == HistoryUse::Motion);
  });
  return found->second;
}

std::vector<std::string> Histories::notes() const {
  std::vector<std::string> notes;
  for (const SceneNode& node : list_.sublists()) {
    if (is_given(node.name())) continue;
    const TimeFunction& function = *functions_.at(node.name());
    const bool is_table = std::isfinite(function.last_time());
    const double end = is_table ? function.last_time() : function.ramp_end();
    if (end <= final_time_ + 1e-9 * (final_time_ - initial_time_)) continue;
    if (is_table && function.at(end).value == function.at(final_time_).value) continue;  // it only holds
    notes.push_back(placed(node.path(), fmt::format("the {} ends at t = {} T0, after the Final Time {} of the run",
                                                    is_table ? "table" : "ramp", end, final_time_)));
  }
  return notes;
}

}  // namespace ixos
