#include "scene/explain/si_explanation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scene/explain/regime.hpp"
#include "scene/read/scene_units.hpp"

namespace ixos {
namespace {

/// Writes numbers as "10 L0 = 10 nm".
class Writer {
 public:
  explicit Writer(const UnitSystem& units) : units_(units) {}
  std::string operator()(double value, const std::string& expression, const std::string& si = "") const {
    return fmt::format("{:.6g} {} = {}", value, expression, units_.text(value, expression, si));
  }

 private:
  const UnitSystem& units_;
};

std::string scales(const Simulation& simulation) {
  std::string text = "Units:";
  for (const ResultUnit& unit : simulation.result_units())
    if (unit.quantity != "acceleration" && unit.quantity != "contact_measure" && unit.quantity != "moment")
      text += fmt::format("{} {} = {}", text.back() == ':' ? "" : ",", unit.expression, si_text(unit.scale, unit.si));
  return text +
         (simulation.model().mesh().body_dimension() == 2 ? " (forces, energies and momenta per depth)\n" : "\n");
}

std::string body(const BodyNumbers& numbers, const Writer& write) {
  return fmt::format("  {}: wave speed {}; a wave crosses the longest side, {}, in {}\n", numbers.name,
                     write(numbers.wave_speed, "L0/T0"), write(numbers.size, "L0"), write(numbers.crossing_time, "T0"));
}

std::string surface(const SurfaceNumbers& numbers, const Writer& write) {
  if (numbers.never_bonds)
    return fmt::format("  {}: never bonds, so it has no work of adhesion; faces of the mesh {}\n", numbers.name,
                       write(numbers.face_length, "L0"));
  if (numbers.is_electrode)
    return fmt::format("  {}: an electrode, largest attraction {}; faces of the mesh {}\n", numbers.name,
                       write(numbers.peak_traction, "E0"), write(numbers.face_length, "L0"));
  std::string text = fmt::format("  {}: work of adhesion W {}, largest attraction {}, equilibrium gap {}\n",
                                 numbers.name, write(numbers.work, "E0 L0", "J/m^2"),
                                 write(numbers.peak_traction, "E0"), write(numbers.equilibrium_gap, "L0"));
  text += fmt::format("  {}: elasto-adhesive length W/E {}, cohesive zone {}, faces of the mesh {}\n", numbers.name,
                      write(numbers.elastic_length, "L0"), write(numbers.cohesive_zone, "L0"),
                      write(numbers.face_length, "L0"));
  if (numbers.radius > 0) text += fmt::format("  {}: radius {}\n", numbers.name, write(numbers.radius, "L0"));
  if (const std::string words = regime_in_words(numbers); !words.empty())
    text += fmt::format("  {}: {}\n", numbers.name, words);
  return text;
}

std::string pair(const SurfaceNumbers& numbers, const Writer& write) {
  if (numbers.extent > 0) return surface(numbers, write);
  return fmt::format("  {}: two surfaces of one part, or that do not face each other at rest: they have no regime\n",
                     numbers.name);
}

double length(const std::vector<double>& vector) {
  double square = 0;
  for (double component : vector) square += component * component;
  return std::sqrt(square);
}

/// Returns a line for each body and each load on its volume.
std::string gravity(const Simulation& simulation, const Writer& write) {
  std::string text;
  for (const SceneNode& node : SceneNode(simulation.parameters(), "").sublist("Boundary Conditions").sublists()) {
    const bool acceleration = node.text("Type") == "Gravity";
    if (!acceleration && node.text("Type") != "Body Force") continue;
    const double load = length(node.numbers("Vector"));
    if (!(load > 0)) continue;
    for (const BodyNumbers& own : simulation.characteristic_numbers().bodies) {
      const std::string &block = node.text("Block"), &history = node.text("History");
      if (!block.empty() && block != simulation.materials()[own.material].block) continue;
      text += fmt::format("  {}: gravity length E/weight of {}{}: {}\n", node.name(), own.name,
                          history.empty() ? "" : " for a value of 1 of the history " + in_quotes(history),
                          write(gravity_length(own.modulus, acceleration ? load * own.density : load), "L0"));
    }
  }
  return text;
}

}  // namespace

std::string explain_numbers(const Simulation& simulation) {
  const Writer write(simulation.units());
  std::string text =
      scales(simulation) + "Values in units of the scene and in SI units:\n" +
      values_in_si(simulation.parameters(), simulation.units(), simulation.model().mesh().body_dimension()) +
      "Numbers that follow from them:\n";
  for (const BodyNumbers& numbers : simulation.characteristic_numbers().bodies) text += body(numbers, write);
  for (const SurfaceNumbers& numbers : simulation.characteristic_numbers().surfaces) text += surface(numbers, write);
  for (const SurfaceNumbers& numbers : simulation.characteristic_numbers().pairs) text += pair(numbers, write);
  for (const SceneInteraction& interaction : simulation.interactions())
    if (interaction.is_with_itself())
      text += fmt::format("  {}: a surface that meets itself, which has no regime\n", interaction.node.name());
  return text + gravity(simulation, write);
}

}  // namespace ixos
