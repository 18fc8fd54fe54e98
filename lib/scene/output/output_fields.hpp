/// The catalogue of the fields that a run can write to fields.e.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/state_report.hpp"
#include "model/traits.hpp"
#include "parameters/scene_node.hpp"
#include "time/integrator.hpp"

namespace ixos {

/// The present state of a run, and what several fields share, computed when a field first asks for it.
class FieldFrame {
 public:
  explicit FieldFrame(Integrator& integrator) : integrator_(integrator) {}

  Integrator& integrator() { return integrator_; }
  const Model& model() const { return integrator_.model(); }
  const State& state() const { return integrator_.state(); }
  StateReport report() const { return {model(), state()}; }
  const std::vector<CellFields>& cells();                     ///< see StateReport::cell_fields
  const std::vector<std::vector<SymmetricTensor>>& stress();  ///< see StateReport::cell_stress

 private:
  Integrator& integrator_;
  std::optional<std::vector<CellFields>> cells_;
  std::optional<std::vector<std::vector<SymmetricTensor>>> stress_;
};

/// Values of a field, by component: by local node, ghosts included; or by local block and cell.
using NodalValues = std::vector<std::vector<double>>;
using CellValues = std::vector<std::vector<std::vector<double>>>;

/// The components of a field, whose names end in X, Y, Z; 1, 2, 3; XX, YY, ZZ, XY and in three dimensions YZ, ZX.
/// VTK's readers join them to one array without these endings.
enum class FieldShape { Scalar, Axes, Principal, Symmetric };

/// One field. It has values on nodes or on cells. `nodal` and `cell` are collective.
struct OutputField {
  std::string name;
  std::string sentence;  ///< for documentation; ends with a full stop
  std::string unit;      ///< in L0, E0, T0 and the dimension D; "-" without a unit
  FieldShape shape = FieldShape::Scalar;
  bool usual = false;   ///< written if a scene lists no fields
  std::string needs{};  ///< what a scene must have to have the field: "an interaction"; may be empty
  std::function<bool(const Model&)> present{};  ///< whether it has; collective; null: always
  std::function<NodalValues(FieldFrame&)> nodal{};
  std::function<CellValues(FieldFrame&)> cell{};

  /// Returns the names of the components in a file.
  std::vector<std::string> components(int dimension) const;
};

/// Returns the components of a local array that is valid for owned degrees of freedom, with the ghosts' values.
/// Collective.
NodalValues vector_of_owned(const Model& model, std::vector<double> local);
/// Returns numbers by local node that are valid for owned nodes, with the ghosts' values. Collective.
NodalValues scalar_of_owned(const Model& model, const std::vector<double>& by_node);

/// Returns all fields of any scene, in the order in which files have them.
const std::vector<OutputField>& output_fields();

/// Returns the documentation of the parameter that lists fields.
std::string output_fields_documentation();

/// Throws InputError, with the place `entry` of the list, if a name is given twice, or is neither a field nor one of
/// interaction_fields() of these interactions. The word "default" is allowed too.
void check_field_names(const SceneNode& node, const std::string& entry, const std::vector<std::string>& names,
                       const std::vector<std::string>& interactions);

/// Returns the fields that names of a checked list choose, in the order of the catalogue, then those of single
/// interactions. "default", or an empty list, stands for the usual fields that the model has. Throws InputError if the
/// model lacks what a named field needs. Collective.
std::vector<OutputField> chosen_fields(const std::vector<std::string>& names, const Model& model);

/// Returns a unit with the powers of D worked out: "E0 L0^(D-1)" is "E0 L0" in two dimensions.
std::string unit_in(int dimension, const std::string& unit);

}  // namespace ixos
