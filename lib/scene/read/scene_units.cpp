#include "scene/read/scene_units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Teuchos_Array.hpp>
#include <vector>

#include "base/error.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/parameter_text.hpp"
#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/unit_uses.hpp"
#include "units/documented_unit.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Numbers = Teuchos::Array<double>;
using Path = std::vector<std::string>;

/// Calls visit(path, list, name, valid entry) for each parameter of the list that the valid list knows, at all depths.
template <class AnyList, class Visit>
void walk(AnyList& list, const List& valid, Path& path, const Visit& visit) {
  if (is_free_form(valid) || is_like_root(valid)) return;
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries(list)) names.push_back(name);
  for (const std::string& name : names) {
    if (!list.isSublist(name)) {
      const Teuchos::ParameterEntry* known = valid.getEntryPtr(name);
      if (known != nullptr && !known->isList()) visit(path, list, name, *known);
      continue;
    }
    const std::string here = valid.isSublist(name) ? name : any_name;
    if (!valid.isSublist(here)) continue;
    path.push_back(name);
    walk(list.sublist(name), valid.sublist(here), path, visit);
    path.pop_back();
  }
}

std::string place(const Path& path, const std::string& name) {
  return path.empty() ? name : fmt::format("{}/{}", fmt::join(path, "/"), name);
}

/// Returns the units that apply to these uses.
std::vector<DocumentedUnit> applicable(const std::vector<DocumentedUnit>& all, const std::set<std::string>& uses) {
  std::vector<DocumentedUnit> result;
  for (const DocumentedUnit& unit : all)
    if (unit.use.empty() || uses.count(unit.use) > 0) result.push_back(unit);
  return result;
}

/// Converts numbers with units, `text`, of one parameter.
class Conversion {
 public:
  Conversion(const UnitSystem& units, const std::string& documentation, const std::set<std::string>& uses)
      : documented_(documented_units(documentation)) {
    for (const DocumentedUnit& unit : applicable(documented_, uses))
      targets_.push_back({units.unit(unit.expression), unit.use});
    if (documented_.empty()) targets_.push_back({});
  }

  /// Throws InputError without a path.
  double operator()(const Quantity& quantity, const std::string& text) const {
    if (targets_.empty()) refuse_use(text);
    for (const Target& target : targets_)
      if (quantity.has_unit && quantity.magnitude.dimension != target.unit.dimension)
        refuse(text, quantity.magnitude.dimension, target);
    return in_unit(quantity, quantity.has_unit ? targets_.front().unit : Unit{});
  }

 private:
  struct Target {
    Unit unit;
    std::string use;
  };

  [[noreturn]] static void refuse(const std::string& text, const Dimension& found, const Target& target) {
    const DimensionName needed = dimension_name(target.unit.dimension);
    throw InputError(fmt::format("{} is {}; {} is needed{}{}", in_quotes(text), dimension_name(found).name, needed.name,
                                 target.use.empty() ? "" : " for a " + target.use,
                                 needed.example.empty() ? "" : ", as in \"" + needed.example + '"'));
  }

  [[noreturn]] void refuse_use(const std::string& text) const {
    std::string known;
    for (const DocumentedUnit& unit : documented_) known += (known.empty() ? "" : ", ") + unit.use;
    throw InputError(
        fmt::format("{}: its unit depends on what the scene leaves open ({}). If the dimension of the mesh "
                    "is not known, state it as Dimension beside File",
                    in_quotes(text), known));
  }

  std::vector<DocumentedUnit> documented_;
  std::vector<Target> targets_;
};

void convert(List& list, const std::string& name, const Teuchos::ParameterEntry& valid, const Conversion& conversion) {
  const auto text = list.get<std::string>(name);
  if (valid.isType<double>() && begins_with_number(text)) {
    const Quantity quantity = parse_quantity(text);
    if (quantity.has_unit) list.set(name, conversion(quantity, text));
  } else if (valid.isType<Numbers>() && text.rfind('{', 0) == 0) {
    Numbers values;
    bool has_unit = false;
    for (const Quantity& quantity : parse_quantities(text)) {
      values.push_back(conversion(quantity, text));
      has_unit = has_unit || quantity.has_unit;
    }
    if (has_unit) list.set(name, values);
  }
}

/// Returns a number, or numbers in braces, with their unit in SI.
std::string in_si(const Teuchos::ParameterEntry& entry, const std::string& expression, const UnitSystem& units) {
  if (entry.isType<double>()) return units.text(Teuchos::getValue<double>(entry), expression);
  std::string text;
  for (double value : Teuchos::getValue<Numbers>(entry))
    text += (text.empty() ? "" : ", ") + units.text(value, expression);
  return "{" + text + "}";
}

bool is_worth_showing(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<double>()) return Teuchos::getValue<double>(entry) != 0;
  return entry.isType<Numbers>() && !Teuchos::getValue<Numbers>(entry).empty();
}

}  // namespace

UnitSystem scene_units(const List& scene) {
  const List& valid = scene_parameters().sublist("Units");
  const auto scale = [&](const char* name) {
    const bool given = scene.isSublist("Units") && scene.sublist("Units").isType<std::string>(name);
    return (given ? scene.sublist("Units") : valid).get<std::string>(name);
  };
  return {scale("Length"), scale("Energy Density"), scale("Time")};
}

List in_scene_units(const List& user, const List& valid) {
  List scene(user);
  const UnitSystem units = scene_units(user);
  const UnitUses uses(user, valid);
  Path root;
  walk(scene, valid, root,
       [&](const Path& path, List& list, const std::string& name, const Teuchos::ParameterEntry& known) {
         if (!list.isType<std::string>(name) || known.isType<std::string>()) return;
         try {
           convert(list, name, known, Conversion(units, known.docString(), uses.of(path, list)));
         } catch (const InputError& error) {
           throw InputError(place(path, name) + ": " + error.what());
         }
       });
  return scene;
}

List complete_scene(const List& user) {
  return validated(in_scene_units(user, scene_parameters()), scene_parameters());
}

std::string values_in_si(const List& complete, const UnitSystem& units, int dimension) {
  std::string text;
  const UnitUses uses(complete, scene_parameters(), dimension);
  Path root;
  walk(complete, scene_parameters(), root,
       [&](const Path& path, const List& list, const std::string& name, const Teuchos::ParameterEntry& known) {
         const auto documented = applicable(documented_units(known.docString()), uses.of(path, list));
         const Teuchos::ParameterEntry& entry = list.getEntry(name);
         if (documented.empty() || !is_worth_showing(entry)) return;
         const std::string& expression = documented.front().expression;
         if (expression.find('0') == std::string::npos) return;  // a pure number, an angle, seconds of the clock
         text += fmt::format("  {}: {} {} = {}\n", place(path, name), short_text(entry), expression,
                             in_si(entry, expression, units));
       });
  return text;
}

std::string unit_of(const List& complete, const std::string& asked) {
  std::string unit;
  const UnitUses uses(complete, scene_parameters());
  Path root;
  walk(complete, scene_parameters(), root,
       [&](const Path& path, const List& list, const std::string& name, const Teuchos::ParameterEntry& known) {
         if (place(path, name) != asked) return;
         const auto documented = applicable(documented_units(known.docString()), uses.of(path, list));
         if (documented.size() == 1) unit = documented.front().expression;
       });
  return unit;
}

}  // namespace ixos
