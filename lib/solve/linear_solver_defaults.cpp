#include "solve/linear_solver_defaults.hpp"

#include "base/error.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

bool factorize(const ProblemSize& size) {
  if (size.ranks == 1) return size.dofs <= (size.dimension == 2 ? 300000 : 30000);
  return size.dofs <= (size.dimension == 2 ? 20000 : 5000);
}

void complete_belos(ParameterList& list) {
  ParameterList& belos = list.sublist("Linear Solver Types").sublist("Belos");
  const std::string type = belos.get("Solver Type", std::string("Pseudo Block CG"));
  ParameterList& solver = belos.sublist("Solver Types").sublist(type);
  solver.get("Maximum Iterations", 300);
  solver.get("Verbosity", 0);
  if (type.find("GMRES") != std::string::npos) solver.get("Num Blocks", 100);
  belos.sublist("VerboseObject").get("Verbosity Level", std::string("none"));
}

/// Smoothed aggregation with Chebyshev smoothing: 12 to 21 CG iterations on blocks and thin plates of 100,000 to
/// 360,000 degrees of freedom.
void complete_muelu(ParameterList& list, const ProblemSize& size) {
  ParameterList& muelu = list.sublist("Preconditioner Types").sublist("MueLu");
  muelu.get("verbosity", std::string("none"));
  muelu.get("number of equations", size.dimension);
  muelu.get("coarse: max size", 1500);
  muelu.get("multigrid algorithm", std::string("sa"));
  muelu.get("reuse: type", std::string("RP"));
  if (muelu.isParameter("smoother: type")) return;
  muelu.set("smoother: type", std::string("CHEBYSHEV"));
  muelu.sublist("smoother: params").get("chebyshev: degree", 2);
  muelu.sublist("smoother: params").get("chebyshev: ratio eigenvalue", 7.0);
}

}  // namespace

ParameterList completed_linear_solver(const ParameterList& user, const ProblemSize& size) {
  ParameterList list(user);
  for (const char* name : {"Linear Solver Type", "Preconditioner Type"})
    if (list.isParameter(name) && !list.isType<std::string>(name))
      throw InputError(std::string("Linear Solver/") + name + ": must be a string");
  std::string type = list.get("Linear Solver Type", std::string("Automatic"));
  if (type == "Automatic") type = factorize(size) ? "Direct" : "Belos";
  list.set("Linear Solver Type", type);
  const std::string preconditioner = list.get("Preconditioner Type", std::string(type == "Belos" ? "MueLu" : "None"));
  if (type == "Belos") complete_belos(list);
  if (type == "Direct")
    list.sublist("Linear Solver Types").sublist("Direct").get("Solver Type", std::string("Automatic"));
  if (preconditioner == "MueLu") complete_muelu(list, size);
  if (preconditioner != "None") list.sublist("Reuse").get("Setup Cost", 20.0);
  return list;
}

}  // namespace ixos
