#include "model/half_space_term.hpp"

#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <type_traits>

#include "fem/cell_types.hpp"
#include "interaction/cut_off.hpp"
#include "interaction/surface_kernel.hpp"
#include "model/element_batches.hpp"

namespace ixos {
namespace {

/// Sides of one element type.
template <class SideElement, class Law>
class HalfSpaceTerm final : public Term {
  using Kernel = SurfaceKernel<SideElement, Law>;
  static constexpr std::size_t D = SideElement::dimension + 1;
  static constexpr std::size_t N = Kernel::N;
  using Nodal = typename Kernel::template Nodal<Pack>;

 public:
  HalfSpaceTerm(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern, const Law& law,
                const HalfSpace& wall, const SurfaceOptions& options)
      : law_(law),
        wall_(wall),
        options_(options),
        quadrature_(points(options), ties(mesh, sides)),
        batches_(node_table(sides), pattern, scale_table(mesh, sides)) {
    double origin = 0;
    for (std::size_t d = 0; d < D; ++d) origin += wall.point[d] * wall.normal[d];
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      Small<Pack, N, D> x;
      batches_.gather(b, mesh.coordinates.data(), x);
      reference_gap_.push_back(along_normal(x));
      // The other nodes of a Hermite side are derivatives: no place, and no distance from the origin.
      for (std::size_t a = 0; a < places; ++a) reference_gap_.back()[a] -= origin;
      for (std::size_t q = 0; q < quadrature_.size(); ++q) measure_.push_back(quadrature_.weight[q] * stretch(x, q));
      owned_.emplace_back([&](auto lane) {
        return lane < batches_.lanes(b) && sides[b * static_cast<std::size_t>(pack_width) + lane].owned ? 1.0 : 0.0;
      });
    }
  }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    Pack least_gap = 1.0;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Gaps gaps(*this, b, segment);
      Nodal along{};
      least_gap = smaller(least_gap, Kernel::add_force(law_, quadrature_, measure(b), gaps.segment(), rule, along));
      batches_.scatter_force(b, from_normal(along), f);
    }
    return least(least_gap) > 0;
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Gaps gaps(*this, b, segment);
      Small<Pack, N> along{};
      Kernel::add_tangent(law_, quadrature_, measure(b), gaps.segment(), rule, kind == Tangent::Convex, along);
      Small<Pack, N * D> tangent;
      for (std::size_t r = 0; r < N * D; ++r)
        for (std::size_t c = 0; c < N * D; ++c)
          tangent[r][c] = along[r / D][c / D] * (wall_.normal[r % D] * wall_.normal[c % D]);
      batches_.scatter_tangent(b, tangent, values);
    }
  }

  std::unique_ptr<TangentAction> create_action() const override { return std::make_unique<Action>(*this); }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    double least_gap = 1;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Nodal gap = gaps_of(b, segment.to);
      Nodal rows{};
      for (std::size_t q = 0; q < quadrature_.size(); ++q) {
        const auto& shape = quadrature_.value[q];
        const Pack r = Kernel::interpolate(shape, gap);
        least_gap = std::min(least_gap, least(r));
        double total_shape = 0;
        for (double value : shape) total_shape += std::abs(value);
        const Pack stiffness = total_shape * measure(b)[q] * std::experimental::abs(law_.stiffness(r));
        for (std::size_t a = 0; a < N; ++a) rows[a] += std::abs(shape[a]) * stiffness;
      }
      // |n_i n_j| summed over j.
      double normal_sum = 0;
      for (std::size_t d = 0; d < D; ++d) normal_sum += std::abs(wall_.normal[d]);
      Small<Pack, N, D> along;
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t d = 0; d < D; ++d) along[a][d] = rows[a] * (std::abs(wall_.normal[d]) * normal_sum);
      batches_.scatter_force(b, along, sums);
    }
    return least_gap > 0;
  }

  double energy(const double* u) const override {
    Pack sum = 0.0;
    for (std::size_t b = 0; b < batches_.size(); ++b)
      sum += owned_[b] * Kernel::energy(law_, quadrature_, measure(b), gaps_of(b, u));
    return total(sum);
  }

  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    Pack step = 1.0;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Gaps gaps(*this, b, segment);
      step = smaller(step, Kernel::admissible_step(quadrature_, gaps.segment(), rule, change_of(b, direction),
                                                   options_.margin, law_.equilibrium_gap()));
    }
    return least(step);
  }

  double mean_potential(const Segment& segment) const override {
    Pack sum = 0.0;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Nodal from = gaps_of(b, segment.from), to = gaps_of(b, segment.to);
      for (std::size_t q = 0; q < quadrature_.size(); ++q)
        sum += owned_[b] * measure(b)[q] *
               law_.mean_potential(Kernel::interpolate(quadrature_.value[q], from),
                                   Kernel::interpolate(quadrature_.value[q], to));
    }
    return total(sum);
  }

  double gap_ratio(const double* from, const double* to) const override {
    const double near = 10 * law_.equilibrium_gap();
    double largest = 1;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Nodal start = gaps_of(b, from), end = gaps_of(b, to);
      for (std::size_t q = 0; q < quadrature_.size(); ++q) {
        const Pack r0 = Kernel::interpolate(quadrature_.value[q], start);
        const Pack r1 = Kernel::interpolate(quadrature_.value[q], end);
        const Pack lesser = smaller(r0, r1);
        const Pack ratio = select(lesser < near, Pack((r0 + r1 - lesser) / lesser), Pack(1.0));
        largest = std::max(largest, -least(Pack(-ratio)));
      }
    }
    return largest;
  }

  double rounding(const double* u) const override {
    Pack sum = 0.0;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Nodal gap = gaps_of(b, u);
      for (std::size_t q = 0; q < quadrature_.size(); ++q) {
        const Pack force = measure(b)[q] * law_.magnitude(Kernel::interpolate(quadrature_.value[q], gap));
        sum += owned_[b] * force * force;
      }
    }
    return total(sum);
  }

  void add_nodal_measure(double* measure_by_node) const override {
    for (std::size_t b = 0; b < batches_.size(); ++b)
      for (std::size_t q = 0; q < quadrature_.size(); ++q)
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t lane = 0; lane < batches_.lanes(b); ++lane)
            measure_by_node[static_cast<std::size_t>(batches_.first_dof(b, a, lane)) / D] +=
                batches_.scale(b, a, lane) * quadrature_.value[q][a] * measure(b)[q][lane];
  }

  void report(const double* u, InteractionReport& report) const override {
    report.force.resize(D, 0.0);
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Nodal gap = gaps_of(b, u);
      for (std::size_t q = 0; q < quadrature_.size(); ++q) {
        const Pack r = Kernel::interpolate(quadrature_.value[q], gap);
        const Pack weight = owned_[b] * measure(b)[q];
        report.least_gap = std::min(report.least_gap, least(r));
        report.measure += total(select(r < law_.adhesion_gap(), weight, Pack(0.0)));
        const double force = total(Pack(weight * law_.traction(r)));
        for (std::size_t d = 0; d < D; ++d) report.force[d] += force * wall_.normal[d];
      }
    }
  }

 private:
  /// Keeps the matrix of each side along the wall's normal.
  class Action final : public TangentAction {
   public:
    explicit Action(const HalfSpaceTerm& term) : term_(term), along_(term.batches_.size()) {}

    void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override {
      for (std::size_t b = 0; b < along_.size(); ++b) {
        const Gaps gaps(term_, b, segment);
        along_[b] = {};
        Kernel::add_tangent(term_.law_, term_.quadrature_, term_.measure(b), gaps.segment(), rule,
                            kind == Tangent::Convex, along_[b]);
      }
    }

    void add_product(const double* x, double* y) const override {
      for (std::size_t b = 0; b < along_.size(); ++b) {
        const Nodal change = term_.change_of(b, x);
        Nodal force{};
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t c = 0; c < N; ++c) force[a] += along_[b][a][c] * change[c];
        term_.batches_.scatter_force(b, term_.from_normal(force), y);
      }
    }

    void add_diagonal(double* d) const override {
      for (std::size_t b = 0; b < along_.size(); ++b) {
        Small<Pack, N, D> diagonal;
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i)
            diagonal[a][i] = along_[b][a][a] * (term_.wall_.normal[i] * term_.wall_.normal[i]);
        term_.batches_.scatter_diagonal(b, diagonal, d);
      }
    }

   private:
    const HalfSpaceTerm& term_;
    std::vector<Small<Pack, N>> along_;
  };

  /// Nodal gaps of one batch at the ends of the segment.
  class Gaps {
   public:
    Gaps(const HalfSpaceTerm& term, std::size_t b, const Segment& segment)
        : has_from_(segment.from != nullptr), has_velocity_(segment.velocity != nullptr) {
      to_ = term.gaps_of(b, segment.to);
      if (has_from_) from_ = term.gaps_of(b, segment.from);
      if (has_velocity_) velocity_ = term.change_of(b, segment.velocity);
    }
    typename Kernel::template Segment<Pack> segment() const {
      return {has_from_ ? &from_ : nullptr, has_velocity_ ? &velocity_ : nullptr, &to_};
    }

   private:
    bool has_from_, has_velocity_;
    Nodal to_, from_, velocity_;
  };

  static constexpr std::size_t places = std::is_same_v<SideElement, HermiteEdge> ? 2 : N;

  static std::array<int, D - 1> points(const SurfaceOptions& options) {
    std::array<int, D - 1> counts;
    const int own = SideElement::default_points[0] > 3 ? 8 : 5;  // beyond order 2 more
    counts.fill(options.points > 0 ? options.points : own);
    return counts;
  }

  /// The tied edges, the same of all sides.
  static unsigned ties(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
    if (sides.empty()) return 0;
    return side_ties(mesh.blocks[static_cast<std::size_t>(sides.front().block)], sides.front().side);
  }

  static std::vector<double> scale_table(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
    std::vector<double> scales;
    if (places == N) return scales;
    for (const LocalSide& side : sides)
      for (int a : {0, 1, 4, 5})
        scales.push_back(node_scale(mesh.blocks[static_cast<std::size_t>(side.block)], side.cell, a));
    return scales;
  }

  static std::vector<int> node_table(const std::vector<LocalSide>& sides) {
    std::vector<int> nodes;
    for (const LocalSide& side : sides) nodes.insert(nodes.end(), side.nodes.begin(), side.nodes.end());
    return nodes;
  }

  Nodal along_normal(const Small<Pack, N, D>& vectors) const {
    Nodal result;
    for (std::size_t a = 0; a < N; ++a) {
      result[a] = vectors[a][0] * wall_.normal[0];
      for (std::size_t d = 1; d < D; ++d) result[a] += vectors[a][d] * wall_.normal[d];
    }
    return result;
  }

  Small<Pack, N, D> from_normal(const Nodal& along) const {
    Small<Pack, N, D> result;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) result[a][d] = along[a] * wall_.normal[d];
    return result;
  }

  Nodal change_of(std::size_t b, const double* local) const {
    Small<Pack, N, D> values;
    batches_.gather(b, local, values);
    return along_normal(values);
  }

  Nodal gaps_of(std::size_t b, const double* u) const {
    Nodal gap = change_of(b, u);
    for (std::size_t a = 0; a < N; ++a) gap[a] += reference_gap_[b][a];
    return gap;
  }

  /// Reference length or area per unit of the reference side at quadrature point q.
  Pack stretch(const Small<Pack, N, D>& x, std::size_t q) const {
    Small<Pack, D - 1, D> tangent{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t k = 0; k + 1 < D; ++k)
        for (std::size_t d = 0; d < D; ++d) tangent[k][d] += quadrature_.gradient[q][a][k] * x[a][d];
    Pack square = 0.0;
    if constexpr (D == 2) {
      square = tangent[0][0] * tangent[0][0] + tangent[0][1] * tangent[0][1];
    } else {
      for (std::size_t d = 0; d < 3; ++d) {
        const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
        const Pack component = tangent[0][e] * tangent[1][f] - tangent[0][f] * tangent[1][e];
        square += component * component;
      }
    }
    return std::experimental::sqrt(square);
  }

  const Pack* measure(std::size_t b) const { return &measure_[b * quadrature_.size()]; }

  Law law_;
  HalfSpace wall_;
  SurfaceOptions options_;
  ShapeTable<SideElement> quadrature_;
  ElementBatches<N, D> batches_;
  std::vector<Nodal> reference_gap_;
  std::vector<Pack> measure_;  ///< batches x quadrature points
  std::vector<Pack> owned_;    ///< 1 for sides that count here
};

template <class Law>
std::vector<std::unique_ptr<Term>> make_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides,
                                              const Pattern& pattern, const Law& law, const HalfSpace& wall,
                                              const SurfaceOptions& options) {
  // A set may hold enriched sides beside plain ones.
  std::map<std::tuple<std::size_t, bool, unsigned>, std::vector<LocalSide>> groups;
  for (const LocalSide& side : sides) {
    const LocalBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    const bool hermite = block.type == CellType::Quad4CH;
    groups[{side.nodes.size(), hermite, side_ties(block, side.side)}].push_back(side);
  }
  std::vector<std::unique_ptr<Term>> terms;
  // A rank without sides has a term too: what follows from there being one is collective.
  if (groups.empty() && mesh.dimension == 2)
    terms.push_back(std::make_unique<HalfSpaceTerm<Line2, Law>>(mesh, sides, pattern, law, wall, options));
  if (groups.empty() && mesh.dimension == 3)
    terms.push_back(std::make_unique<HalfSpaceTerm<Multilinear<2>, Law>>(mesh, sides, pattern, law, wall, options));
  for (const auto& entry : groups) {
    const std::vector<LocalSide>& group = entry.second;
    const CellType type = mesh.blocks[static_cast<std::size_t>(group.front().block)].type;
    with_side_element(type, group.front().side, [&](auto side) {
      using SideElement = typename decltype(side)::type;
      terms.push_back(std::make_unique<HalfSpaceTerm<SideElement, Law>>(mesh, group, pattern, law, wall, options));
    });
  }
  return terms;
}

}  // namespace

std::vector<std::unique_ptr<Term>> make_half_space_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides,
                                                         const Pattern& pattern, const VanDerWaals& law,
                                                         const HalfSpace& wall, const SurfaceOptions& options) {
  if (options.cutoff > 0) return make_terms(mesh, sides, pattern, CutOff(law, options.cutoff), wall, options);
  return make_terms(mesh, sides, pattern, law, wall, options);
}

}  // namespace ixos
