#include "scene/read/maxwell_branches.hpp"

#include <fmt/format.h>

#include "material/prony_table.hpp"
#include "parameters/options.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/range_validator.hpp"
#include "scene/read/obstacle_files.hpp"

namespace ixos {

const char* const maxwell_branches_name = "Maxwell Branches";

namespace {

struct Parameters {
  std::vector<double> times, moduli;
  std::string file;
  HistoryUpdate update = HistoryUpdate::BackwardEuler;
};

const Options<Parameters>& options() {
  static const Options<Parameters> all =
      Options<Parameters>()
          .add("Relaxation Times", &Parameters::times, "Relaxation times tau of the branches [T0].", greater_than(0))
          .add("Moduli", &Parameters::moduli,
               "Shear moduli of the branches, one for each of Relaxation Times [E0]. They add to that of the elastic "
               "law, which is the modulus after a long time; the sum is that of a fast change.",
               greater_than(0))
          .add("File", &Parameters::file,
               "In place of Relaxation Times and Moduli: path of a text file, relative to the scene's folder or to the "
               "working folder. Each line has a relaxation time and a shear modulus, plain numbers in the scene's "
               "units; a # begins a comment.")
          .choose("History Update", &Parameters::update,
                  {{"Backward Euler", HistoryUpdate::BackwardEuler}, {"Second Order", HistoryUpdate::SecondOrder}},
                  "How the branches' history follows a step. Backward Euler: from the strain at its end; no step "
                  "dissipates less than 0, whatever its length. Second Order: from the strain in its middle, for "
                  "schemes that average the elastic force over the step, such as Average Vector Field, with steps "
                  "shorter than a third of the shortest relaxation time.");
  return all;
}

std::vector<MaxwellBranch> branches_of(const SceneNode& node, const Parameters& given) {
  if (!given.file.empty())
    node.refuse("File", "\"" + given.file + "\" stands beside Relaxation Times or Moduli; give one or the other");
  if (given.times.size() != given.moduli.size())
    node.refuse("Moduli", fmt::format("has {} values, and Relaxation Times has {}; each branch needs one of both",
                                      given.moduli.size(), given.times.size()));
  std::vector<MaxwellBranch> branches;
  for (std::size_t i = 0; i < given.times.size(); ++i) branches.push_back({given.moduli[i], given.times[i]});
  return branches;
}

}  // namespace

void declare_branches(Teuchos::ParameterList& material) {
  options().declare(material.sublist(
      maxwell_branches_name, false,
      "Viscoelasticity: neo-Hookean springs, each in series with a dashpot, beside the elastic law. They change no "
      "volume. Their stress at a strain held constant falls as exp(-t/tau). Without entries the material is elastic. "
      "Standard and Mean Dilatation elements; schemes that are not explicit and take no discrete gradient."));
}

Teuchos::ParameterList with_branch_files(const Teuchos::ParameterList& scene, const std::string& scene_folder) {
  Teuchos::ParameterList result(scene);
  if (!result.isSublist("Materials")) return result;
  Teuchos::ParameterList& materials = result.sublist("Materials");
  for (const auto& [name, entry] : entries(scene.sublist("Materials"))) {
    if (!materials.isSublist(name) || !materials.sublist(name).isSublist(maxwell_branches_name)) continue;
    Teuchos::ParameterList& own = materials.sublist(name).sublist(maxwell_branches_name);
    const bool has_file = own.isType<std::string>("File") && !own.get<std::string>("File").empty();
    if (!has_file || own.isParameter("Relaxation Times") || own.isParameter("Moduli")) continue;
    const SceneNode node(own, "Materials/" + name + "/" + maxwell_branches_name);
    Teuchos::Array<double> times, moduli;
    for (const MaxwellBranch& branch : at(node.path_of("File"), [&] {
           return read_prony_table(path_beside(scene_folder, own.get<std::string>("File")));
         })) {
      times.push_back(branch.time);
      moduli.push_back(branch.modulus);
    }
    own.set("Relaxation Times", times);
    own.set("Moduli", moduli);
    own.remove("File");
  }
  return result;
}

void read_branches(const SceneNode& node, Material& material) {
  const SceneNode own = node.sublist(maxwell_branches_name);
  const Parameters given = options().read(own);
  material.branches = branches_of(own, given);
  material.history_update = given.update;
}

}  // namespace ixos
