#include <algorithm>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include "solve/direct/band_ldu.hpp"
#include "solve/direct/first_rank_factorization.hpp"
#include "solve/direct/selected_entries.hpp"

namespace ixos {
namespace {

/// Returns the place of each row in the reverse order of Cuthill and McKee (1969).
std::vector<int> band_order(CollectedMatrix& matrix) {
  const auto size = static_cast<std::size_t>(matrix.size());
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i < matrix.size(); ++i)
    for (int k = matrix.starts()[i]; k < matrix.starts()[i + 1]; ++k)
      if (matrix.columns()[k] != i) edges.emplace_back(i, matrix.columns()[k]);
  const boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property, boost::no_property,
                                           int, int>
      graph(boost::edges_are_sorted, edges.begin(), edges.end(), matrix.size());
  std::vector<int> order(size), place(size);
  std::vector<boost::default_color_type> colors(size);
  const auto index = get(boost::vertex_index, graph);
  boost::cuthill_mckee_ordering(graph, order.rbegin(), boost::make_iterator_property_map(colors.begin(), index),
                                boost::make_out_degree_map(graph));
  for (std::size_t i = 0; i < size; ++i) place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  return place;
}

/// Entries of a column, in the quadratic mean, from which a band is wide: a sparse factorisation takes less time and
/// memory.
constexpr double wide = 500;

/// Below this ratio of pivots KLU, which chooses its pivots, takes the place of a band without symmetry.
constexpr double least_pivot_ratio = 1e-12;

class Band final : public FirstRankFactorization {
 public:
  explicit Band(BandLdu::Symmetry symmetry) : symmetric_(symmetry == BandLdu::Symmetry::Symmetric) {}

  void analyze(const Teuchos::RCP<const CrsMatrix>& matrix) override {
    matrix_ = std::make_unique<CollectedMatrix>(matrix);
    fit_ = Fit::Narrow;
    if (matrix_->root()) {
      try {
        fit_ = make_room();
      } catch (const std::bad_alloc&) {
        fit_ = Fit::NoMemory;
      }
    }
    fit_ = static_cast<Fit>(matrix_->agreed(static_cast<int>(fit_)));
    if (fit_ == Fit::NoMemory) throw std::bad_alloc();
    if (fit_ == Fit::Narrow) read_.share(*matrix_);
  }
  bool suits() const override { return fit_ == Fit::Narrow; }

  void factor() override {
    substitutes_ = false;
    if (matrix_->root()) ldu_.clear();
    read_.copy(ldu_.entries());
    const bool done = !matrix_->root() || (ldu_.factor() && (symmetric_ || ldu_.pivot_ratio() > least_pivot_ratio));
    if (matrix_->agreed(done ? 0 : 1) == 0) return;
    if (symmetric_) throw std::runtime_error("the factorisation \"Band\" meets a pivot that is zero or not finite");
    if (!klu_) {
      klu_ = make_klu();
      klu_->analyze(matrix_->source());
    }
    klu_->remember({});  // new pivots for each such matrix: a restart does not know earlier ones
    klu_->factor();
    substitutes_ = true;
  }

  CollectedMatrix& collected() override { return *matrix_; }
  const double* solve_collected(const double* b) override {
    solve_collected({b}, {solution_.data()});
    return solution_.data();
  }
  void solve_collected(const std::vector<const double*>& b, const std::vector<double*>& x) override {
    if (substitutes_) return klu_->solve_collected(b, x);
    const std::size_t stride = ldu_.padded_size();
    permuted_.assign(b.size() * stride, 0.0);
    for (std::size_t k = 0; k < b.size(); ++k)
      for (std::size_t i = 0; i < order_.size(); ++i)
        permuted_[k * stride + static_cast<std::size_t>(order_[i])] = b[k][i];
    ldu_.solve(permuted_.data(), b.size());
    for (std::size_t k = 0; k < b.size(); ++k)
      for (std::size_t i = 0; i < order_.size(); ++i)
        x[k][i] = permuted_[k * stride + static_cast<std::size_t>(order_[i])];
  }

  const FactorizationMemory& memory() const override { return memory_; }
  void remember(FactorizationMemory memory) override { memory_ = std::move(memory); }

 private:
  enum class Fit { Narrow, Wide, NoMemory };

  /// Orders the rows and makes room for the band, unless it is wide. On the first rank only.
  Fit make_room() {
    order_ = band_order(*matrix_);
    std::vector<int> last(order_.size(), 0);
    for_each_entry([&](int, int i, int j) {
      int& end = last[static_cast<std::size_t>(std::min(i, j))];
      end = std::max({end, i, j});
    });
    if (BandLdu::operations(last) > wide * wide * matrix_->size()) return Fit::Wide;
    ldu_ = BandLdu(last, symmetric_ ? BandLdu::Symmetry::Symmetric : BandLdu::Symmetry::None);
    select_entries();
    solution_.resize(order_.size());
    return Fit::Narrow;
  }
  void select_entries() {
    std::vector<int> entries;
    std::vector<std::size_t> places;
    for_each_entry([&](int k, int i, int j) {
      entries.push_back(k);
      places.push_back(ldu_.place(i, j));
    });
    read_.select(*matrix_, entries, places);
  }
  /// Calls f(k, i, j) with the index of each entry and its place in the new order: in the lower triangle, i >= j, if
  /// the matrix is symmetric.
  template <class F>
  void for_each_entry(const F& f) const {
    const int *starts = matrix_->starts(), *columns = matrix_->columns();
    for (int row = 0; row < matrix_->size(); ++row)
      for (int k = starts[row]; k < starts[row + 1]; ++k) {
        const int i = order_[static_cast<std::size_t>(row)], j = order_[static_cast<std::size_t>(columns[k])];
        if (!symmetric_ || i >= j) f(k, i, j);
      }
  }

  std::unique_ptr<CollectedMatrix> matrix_;
  std::vector<int> order_;  ///< place of each row in the band
  bool symmetric_;
  BandLdu ldu_;
  SelectedEntries read_;                         ///< those that the factors need, in that order
  std::unique_ptr<FirstRankFactorization> klu_;  ///< for matrices whose pivots are too small
  bool substitutes_ = false;                     ///< the last matrix was such a one
  std::vector<double> permuted_, solution_;
  FactorizationMemory memory_;
  Fit fit_ = Fit::Narrow;
};

}  // namespace

std::unique_ptr<Factorization> make_band() { return std::make_unique<Band>(BandLdu::Symmetry::Symmetric); }
std::unique_ptr<Factorization> make_band_lu() { return std::make_unique<Band>(BandLdu::Symmetry::None); }

}  // namespace ixos
