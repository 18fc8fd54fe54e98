#include "solve/choice/linear_solver_defaults.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "solve/direct/factorization.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

bool factorize_on_first_rank(const ProblemSize& size) {
  if (size.ranks == 1) return size.dofs <= (size.dimension == 2 ? 300000 : 30000);
  return size.dofs <= (size.dimension == 2 ? 50000 : 5000);
}

/// A spatula of 403,000 degrees of freedom (width 320): MUMPS in single precision takes a fifth of MueLu's time. A cube
/// of 108,000 (width 1089): twice as much.
bool factorize_on_all_ranks(const ProblemSize& size) {
  return size.asymmetry.empty() && size.dimension == 3 && size.width <= 600 && size.dofs <= 2000000;
}

bool factorize(const ProblemSize& size) { return factorize_on_first_rank(size) || factorize_on_all_ranks(size); }

/// Degrees of freedom from which wide bodies are not factorised for each tangent.
constexpr long long least_kept = 2001;

/// Whether each tangent gets the factors of its band. Columns have about 2.4 times as many entries as a level has nodes
/// in 2D, 4 to 7 times as many in 3D. With 24, 58 and 88 entries and 3,200, 6,700 and 14,500 degrees of freedom the
/// factors take 0.2, 1.1 and 5 ms, CHOLMOD's 1.0, 4 and 8 ms, an iteration of CG 0.1, 0.3 and 0.8 ms. A beam of 80 x 4
/// x 4 linear cells (width 25) takes 0.7 times as long as with CG and MUMPS, blocks of 5^3 and 7^3 cells 0.3 and 0.5
/// times as long as with CHOLMOD.
bool has_narrow_band(const ProblemSize& size) {
  if (!factorize_on_first_rank(size)) return false;
  return size.dofs < least_kept || size.width <= (size.dimension == 2 ? 40 : 25);
}

/// Whether a band makes the cheapest factors. In 3D it preconditions CG: with 20 x 6 x 6 linear cells (width 49) a run
/// takes 0.7 times as long as with MUMPS in single precision, with 20 x 10 x 10 cells (width 121) twice as long.
bool has_band(const ProblemSize& size) {
  return has_narrow_band(size) || (factorize_on_first_rank(size) && size.dimension == 3 && size.width <= 60);
}

/// The factorisations of unsymmetric matrices: a band takes twice the time of a symmetric one, KLU several times that.
std::string unsymmetric_factorization(const ProblemSize& size) { return has_band(size) ? "Band LU" : "KLU"; }

std::string preconditioning_factorization(const ProblemSize& size) {
  if (!size.asymmetry.empty()) return unsymmetric_factorization(size);
  if (has_band(size)) return "Band";
  // CHOLMOD's way with indefinite matrices, the simplicial L D L^T, is slow in three dimensions.
  const bool alone = size.ranks == 1 && size.dimension == 3;
  return alone || !factorize_on_first_rank(size) ? "MUMPS Single" : first_rank_factorization();
}

/// KLU, used in builds without CHOLMOD, fills in too much in three dimensions.
std::string direct_factorization(const ProblemSize& size) {
  if (!size.asymmetry.empty()) return unsymmetric_factorization(size);
  if (has_band(size)) return "Band";
  return first_rank_factorization() == "KLU" && size.dimension == 3 ? "MUMPS" : first_rank_factorization();
}

/// A cube of 108,000 degrees of freedom: Chebyshev's polynomial takes a fifth of MueLu's time at a stiffness of 3, half
/// at 72, as much at 1,150; one of 2,200 takes 0.6 of MUMPS' at 140.
bool has_short_steps(const ProblemSize& size) {
  return size.asymmetry.empty() && size.matrix_only.empty() && size.dimension == 3 && size.stiffness <= 250;
}

/// Degrees of freedom from which two levels beat a factorisation on a compact body of linear cells.
constexpr long long least_linear = 5000;

/// Whether a body is better off with two levels than with a factorisation. Cubes of 4^3, 6^3 and 8^3 quadratic cells on
/// a wall take 0.5, 0.2 and 0.1 times the processor time of MUMPS, those of 12^3, 16^3 and 20^3 linear cells 0.6, 0.4
/// and 0.3 times, 44 x 12 x 12 linear cells 0.4 times. Long cells take more CG iterations: 16^3 linear cells with edges
/// of ratio 5 take 0.8 times, of ratio 10 from 0.9 to 1.8 times, of ratio 40 from 2 to 4 times. A body that is L times
/// as long as wide has L^(-2/3) times the two-thirds power of its nodes in a cut. Levels of quadratic cells have two
/// layers of nodes.
bool prefers_two_levels(const ProblemSize& size) {
  const double cut = size.quadratic ? size.width / 2 : size.width;
  return size.ranks == 1 && size.dofs >= (size.quadratic ? least_kept : least_linear) && size.aspect <= 6 &&
         3 * cut > std::pow(static_cast<double>(size.dofs) / 3, 2.0 / 3);
}

/// Whether the cycle of two levels is possible, and better than a matrix.
bool suits_two_levels(const ProblemSize& size) {
  return (size.quadratic || size.refined) && size.fine_only.empty() && size.asymmetry.empty() &&
         size.matrix_only.empty() && size.dimension == 3 &&
         (!factorize_on_first_rank(size) || prefers_two_levels(size));
}

/// Returns the price of a new preconditioner in iterations.
double setup_cost(const std::string& preconditioner) {
  if (preconditioner == "Chebyshev") return 4;  // ten products; an iteration takes three
  if (preconditioner == "Two-Level") return 12;
  return 20;
}

void complete_direct(ParameterList& list, const ProblemSize& size) {
  ParameterList& direct = list.sublist("Linear Solver Types").sublist("Direct");
  const std::string type = direct.get("Solver Type", direct_factorization(size));
  if (type == "MUMPS Single")
    throw InputError(
        "Linear Solver/Linear Solver Types/Direct/Solver Type: \"MUMPS Single\" can only be a preconditioner; use "
        "\"MUMPS\"");
}

void complete_belos(ParameterList& list, const ProblemSize& size) {
  ParameterList& belos = list.sublist("Linear Solver Types").sublist("Belos");
  const std::string type =
      belos.get("Solver Type", std::string(size.asymmetry.empty() ? "Pseudo Block CG" : "Pseudo Block GMRES"));
  ParameterList& solver = belos.sublist("Solver Types").sublist(type);
  solver.get("Maximum Iterations", 300);
  solver.get("Verbosity", 0);
  if (type.find("GMRES") != std::string::npos) solver.get("Num Blocks", 100);
  belos.sublist("VerboseObject").get("Verbosity Level", std::string("none"));
}

/// Smoothed aggregation with Chebyshev smoothing: 12 to 21 CG iterations on blocks and thin plates of 100,000 to
/// 360,000 degrees of freedom.
void complete_muelu(ParameterList& muelu, const ProblemSize& size, int degree = 2, double ratio = 7) {
  muelu.get("verbosity", std::string("none"));
  muelu.get("number of equations", size.dimension);
  muelu.get("coarse: max size", 1500);
  muelu.get("multigrid algorithm", std::string("sa"));
  muelu.get("reuse: type", std::string("RP"));
  if (muelu.isParameter("smoother: type")) return;
  muelu.set("smoother: type", std::string("CHEBYSHEV"));
  muelu.sublist("smoother: params").get("chebyshev: degree", degree);
  muelu.sublist("smoother: params").get("chebyshev: ratio eigenvalue", ratio);
}

/// Returns the entry's value, one of the names.
std::string choice(ParameterList& list, const char* name, const std::string& fallback,
                   const std::vector<std::string>& names, const std::string& path = "Linear Solver/") {
  if (list.isParameter(name) && !list.isType<std::string>(name)) throw InputError(path + name + ": must be a string");
  std::string value = list.get(name, fallback);
  if (std::find(names.begin(), names.end(), value) == names.end())
    throw InputError(path + name + ": \"" + value + "\" does not exist; did you mean \"" + closest_name(value, names) +
                     "\"? Allowed: " + quoted_list(names));
  return value;
}

/// Chooses the coarse solver, unless the list does. It takes a factorisation of the coarse cells' matrix if that is
/// cheap, else MueLu. On blocks of 10,000 coarse degrees of freedom MueLu takes 0.8 of the factorisation's time. It
/// smooths them more than a fine matrix, so that iterations stay those of an exact coarse solve: 7 or 8 from 14^3 to
/// 56^3 linear cells in place of 7 to 10, in the same time.
void complete_two_level(ParameterList& list, const ProblemSize& size) {
  ParameterList& coarse = list.sublist("Preconditioner Types").sublist("Two-Level").sublist("Coarse");
  ProblemSize corners = size;
  corners.dofs = size.dofs >> size.dimension;
  corners.width = size.width / (1 << (size.dimension - 1));
  const std::string type = choice(coarse, "Type", "Automatic", {"Automatic", "MueLu", "Direct"},
                                  "Linear Solver/Preconditioner Types/Two-Level/Coarse/");
  const bool cheap = factorize_on_first_rank(corners) && (size.dimension == 2 || corners.dofs <= 5000);
  if (type == "Automatic") coarse.set("Type", std::string(cheap ? "Direct" : "MueLu"));
  if (coarse.get<std::string>("Type") == "MueLu")
    complete_muelu(coarse.sublist("MueLu"), size, 4, 20);
  else
    coarse.sublist("Direct").get("Solver Type", preconditioning_factorization(corners));
}

/// Throws InputError if the list asks for a solver of symmetric matrices.
void refuse_symmetric_solvers(ParameterList& list, const std::string& asymmetry) {
  if (asymmetry.empty()) return;
  const auto refuse = [&](const std::string& entry, const std::string& value, const std::string& instead) {
    throw InputError("Linear Solver/" + entry + ": \"" + value + "\" needs a symmetric matrix; because of " +
                     asymmetry + ", the tangent is not symmetric; use " + instead);
  };
  struct Symmetric {
    std::string type;
    std::vector<std::string> solvers;
    std::string instead;
  };
  static const std::vector<Symmetric> all{
      {"Direct", {"Band", "CHOLMOD", "MUMPS"}, "\"Band LU\" or \"KLU\""},
      {"Belos",
       {"Block CG", "Pseudo Block CG", "Pseudo Block Stochastic CG", "CG", "RCG", "PCPG", "MINRES"},
       "\"Pseudo Block GMRES\""},
      {"Amesos2", {"CHOLMOD"}, "\"KLU2\""}};
  const auto chosen = list.get<std::string>("Linear Solver Type");
  for (const Symmetric& symmetric : all) {
    const std::string types = "Linear Solver Types";
    if (chosen != "Automatic" && chosen != symmetric.type) continue;
    if (!list.isSublist(types) || !list.sublist(types).isSublist(symmetric.type)) continue;
    const ParameterList& asked = list.sublist(types).sublist(symmetric.type);
    if (!asked.isType<std::string>("Solver Type")) continue;
    const auto& solver = asked.get<std::string>("Solver Type");
    if (std::find(symmetric.solvers.begin(), symmetric.solvers.end(), solver) != symmetric.solvers.end())
      refuse(types + "/" + symmetric.type + "/Solver Type", solver, symmetric.instead);
  }
  if (list.get<std::string>("Preconditioner Type") == "Chebyshev")
    refuse("Preconditioner Type", "Chebyshev", "\"MueLu\", \"Ifpack2\" or \"Direct\"");
}

[[noreturn]] void refuse_two_level(const std::string& need) {
  throw InputError("Linear Solver/Preconditioner Type: \"Two-Level\" needs " + need +
                   "; use \"MueLu\", \"Ifpack2\" or \"Direct\"");
}

/// Throws InputError if the two-level cycle is not possible.
void check_two_level(const ProblemSize& size, const std::string& op) {
  require_coarse_cells(size);
  if (!size.asymmetry.empty())
    refuse_two_level("a symmetric matrix; because of " + size.asymmetry + ", the tangent is not symmetric");
  if (!size.matrix_only.empty())
    refuse_two_level("matrix-free tangents, which are not offered for " + size.matrix_only);
  require_coarse_terms(size);
  if (op == "Assembled") refuse_two_level("matrix-free tangents, and Operator is \"Assembled\"");
}

void refuse_matrix_free(const ProblemSize& size) {
  if (!size.asymmetry.empty())
    throw InputError("Linear Solver/Operator: \"Matrix-Free\" needs a symmetric tangent; because of " + size.asymmetry +
                     ", the tangent is not symmetric; use \"Assembled\"");
  if (!size.matrix_only.empty())
    throw InputError("Linear Solver/Operator: \"Matrix-Free\" is not offered for " + size.matrix_only +
                     "; use \"Assembled\"");
}

ParameterList complete(const ParameterList& user, const ProblemSize& size) {
  ParameterList list(user);
  std::string type = choice(list, "Linear Solver Type", "Automatic", {"Automatic", "Direct", "Belos", "Amesos2"});
  bool asks = list.isParameter("Preconditioner Type");
  std::string preconditioner =
      choice(list, "Preconditioner Type", "None", {"None", "MueLu", "Ifpack2", "Direct", "Chebyshev", "Two-Level"});
  const std::string op = choice(list, "Operator", "Automatic", {"Automatic", "Assembled", "Matrix-Free"});
  if (op == "Matrix-Free") refuse_matrix_free(size);
  if (preconditioner == "Two-Level") check_two_level(size, op);
  refuse_symmetric_solvers(list, size.asymmetry);
  if (type == "Automatic") {
    const bool two_levels = op != "Assembled" && suits_two_levels(size);
    const bool direct = factorize(size) && !asks && !(two_levels && prefers_two_levels(size));
    const bool polynomial = !asks && size.dofs >= least_kept && op != "Assembled" && has_short_steps(size);
    type = direct && !polynomial && (size.dofs < least_kept || (op != "Matrix-Free" && has_narrow_band(size)))
               ? "Direct"
               : "Belos";
    if (type == "Belos" && direct) preconditioner = "Direct";
    if (polynomial) preconditioner = "Chebyshev";
    asks = asks || direct || polynomial;
  }
  if (type == "Belos" && !asks) preconditioner = op != "Assembled" && suits_two_levels(size) ? "Two-Level" : "MueLu";
  const bool without_matrix = preconditions_without_matrix(preconditioner);
  const bool large =
      preconditioner == "Two-Level" || (size.dimension == 3 && (!factorize_on_first_rank(size) || without_matrix));
  const bool can = size.asymmetry.empty() && size.matrix_only.empty() && type == "Belos";
  if (op == "Matrix-Free" && !can)
    throw InputError("Linear Solver/Operator: \"Matrix-Free\" needs Linear Solver Type \"Belos\", not \"" + type +
                     "\"; or use \"Assembled\"");
  list.set("Operator", op == "Matrix-Free" || (op == "Automatic" && can && large) ? "Matrix-Free" : "Assembled");
  if (type != "Belos" && preconditioner != "None")
    throw InputError("Linear Solver/Preconditioner Type: \"" + preconditioner +
                     "\" needs Linear Solver Type \"Belos\"; \"" + type + "\" has no preconditioner");
  list.set("Linear Solver Type", type);
  list.set("Preconditioner Type", preconditioner);
  if (type == "Belos") complete_belos(list, size);
  if (type == "Direct") complete_direct(list, size);
  if (preconditioner == "Direct")
    list.sublist("Preconditioner Types").sublist("Direct").get("Solver Type", preconditioning_factorization(size));
  if (preconditioner == "MueLu") complete_muelu(list.sublist("Preconditioner Types").sublist("MueLu"), size);
  if (preconditioner == "Two-Level") complete_two_level(list, size);
  if (preconditioner != "None" && !list.sublist("Reuse").isParameter("Setup Cost"))
    list.sublist("Reuse").set("Setup Cost", setup_cost(preconditioner));
  return list;
}

}  // namespace

void require_coarse_cells(const ProblemSize& size) {
  if (!size.quadratic && !size.refined)
    refuse_two_level(
        "a mesh of quadratic cells, or of linear ones that halve larger cells in each direction without enriched "
        "sides, and this one has linear cells that do not");
}

void require_coarse_terms(const ProblemSize& size) {
  if (!size.fine_only.empty())
    refuse_two_level("a Galerkin product on linear cells (TangentAction::add_coarse), which " + size.fine_only +
                     " does not offer");
}

bool may_use_coarse_cells(const ParameterList& user, int dimension, long long dofs, int ranks) {
  if (!user.isType<std::string>("Preconditioner Type")) {
    const bool may_be_preconditioned = !user.isType<std::string>("Linear Solver Type") ||
                                       user.get<std::string>("Linear Solver Type") == "Automatic" ||
                                       user.get<std::string>("Linear Solver Type") == "Belos";
    if (!may_be_preconditioned) return false;
    ProblemSize size;
    size.dimension = dimension;
    size.dofs = dofs;
    size.ranks = ranks;
    return dimension == 3 && (!factorize_on_first_rank(size) || (ranks == 1 && dofs >= least_linear));
  }
  return user.get<std::string>("Preconditioner Type") == "Two-Level";
}

bool preconditions_without_matrix(const std::string& type) { return type == "Chebyshev" || type == "Two-Level"; }

ParameterList completed_linear_solver(const ParameterList& user, const ProblemSize& size) {
  try {
    return complete(user, size);
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {  // a list where a parameter is due, or a value of the wrong type
    throw InputError("Linear Solver: " + last_paragraph(error.what()));
  }
}

std::string linear_solver_in_words(const ParameterList& completed) {
  ParameterList list(completed);  // asking it for a list that is not there adds one
  const auto named = [&list](const char* lists, const std::string& type) {
    const std::string kind = list.sublist(lists).sublist(type).get("Solver Type", "");
    return kind.empty() ? type : type + " (" + kind + ")";
  };
  std::string text = named("Linear Solver Types", list.get<std::string>("Linear Solver Type"));
  const auto preconditioner = list.get<std::string>("Preconditioner Type");
  if (preconditioner != "None") text += ", preconditioner " + named("Preconditioner Types", preconditioner);
  if (preconditioner == "Two-Level") {
    ParameterList& coarse = list.sublist("Preconditioner Types").sublist(preconditioner).sublist("Coarse");
    const auto coarse_type = coarse.get<std::string>("Type");
    const std::string kind = coarse.sublist(coarse_type).get("Solver Type", "");
    text += " (coarse: " + coarse_type + (kind.empty() ? "" : " (" + kind + ")") + ")";
  }
  return text +
         (list.get<std::string>("Operator") == "Matrix-Free" ? ", matrix-free tangents" : ", assembled tangents");
}

}  // namespace ixos
