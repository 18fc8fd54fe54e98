#include "scene/read/initial_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "discretization/nodal_measure.hpp"
#include "interaction/direction.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

using Point = std::array<double, 3>;

struct Parameters {
  std::vector<std::string> blocks;
  std::vector<double> velocity, gradient, spin, origin;
};

Options<Parameters> motion_options(const std::string& origin) {
  return Options<Parameters>()
      .add("Velocity", &Parameters::velocity, "Uniform velocity [L0/T0]. If empty, it is zero.", any_number())
      .add("Velocity Gradient", &Parameters::gradient,
           "Velocity gradient L, row by row [1/T0]: v = Velocity + L (X - Origin). A skew-symmetric L is a rotation. "
           "If empty, it is zero.",
           any_number())
      .add("Angular Velocity", &Parameters::spin,
           "Rotation about the Origin [1/T0], in addition: one number in 2D, counter-clockwise, three in 3D. If empty, "
           "it is zero.",
           any_number())
      .add("Origin", &Parameters::origin,
           "Point at which Velocity Gradient and Angular Velocity contribute nothing [L0]. If empty, it is " + origin +
               ".",
           any_number());
}

const Options<Parameters>& all_blocks() {
  static const Options<Parameters> options = motion_options("the origin of coordinates");
  return options;
}

const Options<Parameters>& some_blocks() {
  static const Options<Parameters> options =
      motion_options("the centre of mass of the Blocks")
          .add("Blocks", &Parameters::blocks,
               "Blocks that move so, for example {left_body}. At least one must be given.");
  return options;
}

InitialMotion motion_of(const SceneNode& node, const Parameters& p, int dimension, bool axisymmetric) {
  const auto d = static_cast<std::size_t>(dimension);
  const std::size_t spins = d == 2 ? 1 : 3;
  InitialMotion motion;
  motion.path = node.path();
  motion.blocks = p.blocks;
  motion.velocity = place_of(node, "Velocity", d);
  const auto gradient = node.numbers("Velocity Gradient", d * d, std::vector<double>(d * d, 0.0));
  for (std::size_t i = 0; i < d; ++i) std::copy_n(&gradient[i * d], d, motion.gradient[i].begin());
  const auto spin = node.numbers("Angular Velocity", spins, std::vector<double>(spins, 0.0));
  // Rotation about axis k: in the plane of the two axes behind it, from i to j.
  for (std::size_t s = 0; s < spins; ++s) {
    const std::size_t k = d == 2 ? 2 : s, i = (k + 1) % 3, j = (k + 2) % 3;
    motion.gradient[i][j] -= spin[s];
    motion.gradient[j][i] += spin[s];
  }
  if (!p.origin.empty() || p.blocks.empty()) motion.origin = place_of(node, "Origin", d);
  if (axisymmetric && motion.velocity[0] != 0)
    node.refuse("Velocity", fmt::format("the radial component {} moves an axisymmetric body off its axis; use 0",
                                        motion.velocity[0]));
  if (axisymmetric && spin[0] != 0)
    node.refuse("Angular Velocity", "a body of revolution does not turn in its meridian plane; leave it out");
  return motion;
}

void check_blocks(const SceneNode& node, const std::vector<std::string>& blocks,
                  std::map<std::string, std::string>& owners) {
  if (blocks.empty()) node.refuse("Blocks", "there is none; name the blocks that move so");
  for (const std::string& block : blocks)
    if (const auto [before, fresh] = owners.insert({block, node.path()}); !fresh)
      node.refuse("Blocks", before->second == node.path()
                                ? fmt::format("\"{}\" is given twice", block)
                                : fmt::format("\"{}\" also moves as {} says", block, before->second));
}

/// Returns the blocks that each motion moves.
std::vector<std::vector<std::size_t>> blocks_of(const std::vector<InitialMotion>& motions, const LocalMesh& mesh) {
  std::vector<std::vector<std::size_t>> result(motions.size());
  std::vector<bool> named(mesh.blocks.size(), false);
  for (std::size_t m = 0; m < motions.size(); ++m)
    for (const std::string& name : motions[m].blocks)
      at(motions[m].path + "/Blocks", [&] {
        for (const std::size_t b : mesh.blocks_named(name)) {
          result[m].push_back(b);
          named[b] = true;
        }
      });
  for (std::size_t m = 0; m < motions.size(); ++m)
    for (std::size_t b = 0; motions[m].blocks.empty() && b < named.size(); ++b)
      if (!named[b]) result[m].push_back(b);
  return result;
}

/// Returns the centre of mass of the blocks; that of a body of revolution is on its axis. Without mass it is the centre
/// of their volume.
Point centre_of(const std::vector<std::size_t>& blocks, const Model& model, const std::vector<Material>& materials) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::array<double, 8> sums{};  // volume and its moments, mass and its moments
  for (const std::size_t b : blocks) {
    const LocalBlock& block = mesh.blocks[b];
    std::vector<double> measure(static_cast<std::size_t>(mesh.nodes()), 0.0);
    add_block_measure(mesh, block, measure);
    const auto material =
        std::find_if(materials.begin(), materials.end(), [&](const Material& own) { return own.block == block.name; });
    const double density = material == materials.end() ? 0 : material->density;
    for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node)
      for (std::size_t k = 0; k < 2; ++k) {
        const double weight = k == 0 ? measure[node] : density * measure[node];
        if (!mesh.is_derivative(node)) sums[4 * k] += weight;
        for (std::size_t i = 0; i < d; ++i) sums[4 * k + 1 + i] += weight * mesh.coordinates[node * d + i];
      }
  }
  model.space().sum(sums.data(), 8);
  const std::size_t kind = sums[4] > 0 ? 4 : 0;
  Point centre{};
  for (std::size_t i = mesh.axisymmetric ? 1 : 0; i < d; ++i) centre[i] = sums[kind + 1 + i] / sums[kind];
  return centre;
}

/// Throws InputError if a tied node was given another velocity than the nodes that it follows.
void refuse_torn_velocities(const Model& model, const std::vector<double>& given, const std::vector<double>& moved) {
  const LocalMesh& mesh = model.mesh();
  if (mesh.global_tied == 0) return;
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double fastest = 0;
  for (const double v : given) fastest = std::max(fastest, std::abs(v));
  fastest = model.space().maximum(fastest);
  together<InputError>(model.space().comm(), [&] {
    for (int node = mesh.ties.first(); node < mesh.nodes() && !mesh.ties.empty(); ++node)
      for (std::size_t i = 0; i < d; ++i) {
        const std::size_t k = static_cast<std::size_t>(node) * d + i;
        if (std::abs(given[k] - moved[k]) > 1e-9 * fastest)
          throw InputError(fmt::format(
              "Initial Conditions: node {} of the mesh follows others (Mesh/Refine, Ties or Periodic), which "
              "have another velocity: along {} {:.6g} L0/T0, not {:.6g} L0/T0; give its block their velocity",
              mesh.message_number(static_cast<std::size_t>(node)), "xyz"[i], moved[k], given[k]));
      }
  });
}

}  // namespace

void declare_initial_conditions(Teuchos::ParameterList& list) {
  all_blocks().declare(list);
  some_blocks().declare(list.sublist(
      any_name, false,
      "Velocities of some blocks, in place of those above: two bodies that fly towards each other. Blocks that share "
      "nodes must have one velocity there."));
}

std::vector<InitialMotion> initial_motions(const SceneNode& initial, int dimension, bool axisymmetric) {
  std::vector<InitialMotion> motions{motion_of(initial, all_blocks().read(initial), dimension, axisymmetric)};
  std::map<std::string, std::string> owners;
  for (const SceneNode& node : initial.sublists()) {
    const Parameters p = some_blocks().read(node);
    check_blocks(node, p.blocks, owners);
    motions.push_back(motion_of(node, p, dimension, axisymmetric));
  }
  return motions;
}

std::vector<double> initial_velocities(const std::vector<InitialMotion>& motions, const Model& model,
                                       const std::vector<Material>& materials) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto blocks = blocks_of(motions, mesh);
  std::vector<double> v(static_cast<std::size_t>(model.space().local()), 0.0);
  std::vector<std::size_t> motion_of_node(static_cast<std::size_t>(mesh.nodes()), motions.size());
  double clash = 0;  // on some rank: the numbers of two motions that differ at a node
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const InitialMotion& motion = motions[m];
    const Point origin = motion.origin || !motion.has_gradient() ? motion.origin.value_or(Point{})
                                                                 : centre_of(blocks[m], model, materials);
    for (const std::size_t b : blocks[m])
      for (const int number : mesh.blocks[b].nodes) {
        const auto node = static_cast<std::size_t>(number);
        if (motion_of_node[node] == m) continue;
        // A derivative node has no place: the field's derivative along the boundary is L dX/ds.
        const double place = mesh.is_derivative(node) ? 0.0 : 1.0;
        for (std::size_t i = 0; i < d; ++i) {
          double sum = place * motion.velocity[i], size = std::abs(sum);
          for (std::size_t j = 0; j < d; ++j) {
            const double term = motion.gradient[i][j] * (mesh.coordinates[node * d + j] - place * origin[j]);
            sum += term;
            size += std::abs(term);
          }
          double& target = v[node * d + i];
          if (motion_of_node[node] < m && std::abs(sum - target) > 1e-9 * (size + std::abs(target)))
            clash = std::max(clash, static_cast<double>(motion_of_node[node] * motions.size() + m));
          target = sum;
        }
        motion_of_node[node] = m;
      }
  }
  clash = model.space().maximum(clash);
  if (clash > 0) {
    const auto pair = static_cast<std::size_t>(clash);
    throw InputError(fmt::format("{}: its blocks share nodes with those of {}, but not the velocities there",
                                 motions[pair % motions.size()].path, motions[pair / motions.size()].path));
  }
  const std::vector<double> given = v;
  model.space().update_ghosts(v.data());
  refuse_torn_velocities(model, given, v);
  return v;
}

}  // namespace ixos
