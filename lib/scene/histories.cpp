#include "scene/histories.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "scene/list_access.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

RampShape shape(const List& list) {
  const auto name = list.get<std::string>("Shape");
  if (name == "Linear") return RampShape::Linear;
  return name == "Cosine" ? RampShape::Cosine : RampShape::Quintic;
}

std::vector<double> array(const List& list, const char* name) {
  const auto& values = list.get<Teuchos::Array<double>>(name);
  return {values.begin(), values.end()};
}

std::shared_ptr<const TimeFunction> make(const List& list) {
  const auto type = list.get<std::string>("Type");
  const List& own = list.sublist(type);
  if (type == "Constant") return constant(own.get<double>("Value"));
  if (type == "Ramp")
    return value_ramp(own.get<double>("Value"), own.get<double>("Start"), own.get<double>("Length"), shape(own));
  if (type == "Rate Ramp")
    return rate_ramp(own.get<double>("Rate"), own.get<double>("Start"), own.get<double>("Length"), shape(own));
  if (type == "Sine")
    return sine(own.get<double>("Offset"), own.get<double>("Amplitude"), own.get<double>("Frequency"),
                own.get<double>("Phase"));
  if (type == "Table") return interpolated(array(own, "Times"), array(own, "Values"));
  return expression(own.get<std::string>("Value"), own.get<std::string>("Velocity"),
                    own.get<std::string>("Acceleration"));
}

}  // namespace

Histories::Histories(const List& list, double initial_time, double final_time)
    : list_(list), initial_time_(initial_time), final_time_(final_time) {
  for (const std::string& name : sublists(list)) {
    const List& own = list.sublist(name);
    functions_[name] = at("Histories/" + name + "/" + own.get<std::string>("Type"), [&own] { return make(own); });
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
  const List& own = list_.sublist(name);
  if (use == HistoryUse::Motion && own.get<std::string>("Type") == "Expression")
    for (const char* derivative : {"Velocity", "Acceleration"})
      if (own.sublist("Expression").get<std::string>(derivative).empty())
        throw InputError(fmt::format("Histories/{}/Expression/{} is missing: a motion needs it", name, derivative));
  const TimeFunction& function = *found->second;
  at("Histories/" + name, [&] {
    const double slack = 1e-9 * (function.last_time() - function.first_time());
    if (function.first_time() > initial_time_ + slack || function.last_time() < final_time_ - slack)
      throw InputError(fmt::format("the table covers the times {} to {}, but the run goes from {} to {}",
                                   function.first_time(), function.last_time(), initial_time_, final_time_));
    if (function.ramp_end() > final_time_ + 1e-9 * (final_time_ - initial_time_))
      throw InputError(fmt::format("the ramp ends at Start + Length = {}, after the Final Time {} of the run",
                                   function.ramp_end(), final_time_));
    check_over(function, initial_time_, final_time_, use == HistoryUse::Motion);
  });
  return found->second;
}

}  // namespace ixos
