/// The responses g of the semi-discrete model.
#pragma once
#include <string>
#include <vector>

#include "embedding/semi_discrete_balance.hpp"
#include "solve/thyra.hpp"

namespace ixos {

/// The numbers j of the responses g_j. Their components have the names and units of history.csv.
enum class Response {
  Energies,     ///< kinetic, elastic and contact (interaction) energy [E0 L0^D]
  Momenta,      ///< linear momentum by axis [E0 T0 L0^(D-1)], angular momentum about the origin [E0 T0 L0^D]
  Interaction,  ///< force on the body by axis, contact measure, least gap (infinite without interactions)
  Reactions     ///< of node sets by axis [E0 L0^(D-1)]; only if sets were named
};

/// Responses on locally replicated spaces: every rank has all components. The model must outlive it.
class SemiDiscreteResponses {
 public:
  /// `reactions`: node sets with constrained degrees of freedom. Throws InputError if there is no such set, or if no
  /// displacement of it is prescribed.
  SemiDiscreteResponses(const Model& model, const std::vector<std::string>& reactions);

  int count() const { return static_cast<int>(names_.size()); }
  VectorSpace space(int response) const { return spaces_[index(response)]; }
  const std::vector<std::string>& names(int response) const { return names_[index(response)]; }

  /// Sets g to the response at an admissible state. Reactions are the balance in the rows of constrained degrees of
  /// freedom, summed over the set without derivative nodes, whose reactions are moments. Collective.
  void evaluate(int response, SemiDiscreteBalance& balance, Vector& g) const;

 private:
  static std::size_t index(int response) { return static_cast<std::size_t>(response); }
  void add_names(std::vector<std::string> names);
  void add_reaction_set(const std::string& name);
  std::vector<double> values(Response response, SemiDiscreteBalance& balance) const;

  const Model& model_;
  std::vector<std::vector<std::string>> names_;
  std::vector<VectorSpace> spaces_;
  std::vector<std::size_t> reaction_sets_;  ///< their numbers in the mesh
};

}  // namespace ixos
