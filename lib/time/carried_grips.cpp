#include "time/carried_grips.hpp"

#include <array>
#include <map>

#include "base/dot.hpp"

namespace ixos {
namespace {

double product(const std::array<double, 3>& x, const double* y, std::size_t d) { return dot(x.data(), y, d); }

}  // namespace

CarriedGrips::CarriedGrips(const Model& model) : model_(model), d_(static_cast<std::size_t>(model.mesh().dimension)) {
  const Pattern& pattern = model.pattern();
  carried_.resize(static_cast<std::size_t>(model.space().owned()));
  for (const int dof : model.constraints().entrusted())
    if (static_cast<std::size_t>(dof) < carried_.size()) carried_[static_cast<std::size_t>(dof)] = true;
  for (const CarriedNodes& nodes : model.carried_nodes()) {
    Grip grip{&nodes, nodes.first() - static_cast<std::size_t>(model.space().first_global()), {}, {}};
    std::map<int, std::size_t> numbers;  // of the carried nodes
    const std::vector<CarriedNodes::Share> shares = nodes.shares(BodySight{});
    for (std::size_t k = 0; k < shares.size(); ++k) numbers[static_cast<int>(shares[k].place / d_)] = k;
    for (int row = 0; row < pattern.rows(); ++row) {
      const auto place = static_cast<std::size_t>(row) * d_, stride = static_cast<std::size_t>(pattern.stride(row));
      const auto own = numbers.find(row);
      pattern.for_each_block(row, [&](int column, int offset) {
        if (pattern.ties().is_tied(column)) return;
        const auto first = static_cast<std::size_t>(offset);
        if (const auto other = numbers.find(column); other != numbers.end())
          grip.columns.push_back({first, stride, other->second, place});
        if (own != numbers.end())
          grip.rows.push_back({first, stride, own->second, static_cast<std::size_t>(column) * d_});
      });
    }
    grips_.push_back(std::move(grip));
  }
}

void CarriedGrips::add_forces(const double* u, const double* f, double* globals) const {
  for (const Grip& grip : grips_) grip.nodes->add_forces(grip.nodes->sight(start_, u), f, globals + grip.first);
}

void CarriedGrips::add_columns(const double* u, const double* values, Border& border) const {
  for (const Grip& grip : grips_) {
    const std::vector<CarriedNodes::Share> shares = grip.nodes->shares(grip.nodes->sight(start_, u));
    for (const std::size_t k : grip.nodes->body().free()) {
      std::vector<double>& column = border.column(grip.first + k);
      for (const Block& block : grip.columns)
        for (std::size_t i = 0; i < d_; ++i)
          column[block.other + i] +=
              product(shares[block.share].motions[k], values + block.first + i * block.stride, d_);
    }
  }
}

void CarriedGrips::add_rows(const double* u, const double* f, const double* values, Border& border) const {
  const std::vector<int>& free = model_.space().globals().free;
  std::vector<std::vector<double>> rows = border.rows();  // of terms alone
  for (std::vector<double>& row : rows) model_.space().condense(row.data());
  for (const Grip& grip : grips_) {
    const BodySight sight = grip.nodes->sight(start_, u);
    const std::vector<CarriedNodes::Share> shares = grip.nodes->shares(sight);
    for (const std::size_t k : grip.nodes->body().free()) {
      // Forces of terms on bodies move with the nodes, and forces on the nodes with everything.
      for (std::size_t i = 0; i < free.size(); ++i) {
        double& by_nodes = border.entry(static_cast<std::size_t>(free[i]), grip.first + k);
        for (const CarriedNodes::Share& share : shares)
          by_nodes += product(share.motions[k], rows[i].data() + share.place, d_);
        double& of_nodes = border.entry(grip.first + k, static_cast<std::size_t>(free[i]));
        for (const CarriedNodes::Share& share : shares)
          if (share.owned) of_nodes += product(share.moments[k], border.columns()[i].data() + share.place, d_);
      }
      std::vector<double>& row = border.row(grip.first + k);
      for (const Block& block : grip.rows)
        for (std::size_t i = 0; i < d_; ++i)
          for (std::size_t j = 0; j < d_; ++j)
            row[block.other + j] += shares[block.share].moments[k][i] * values[block.first + i * block.stride + j];
    }
    const Small<double, 6> turning = grip.nodes->turning(sight, f);
    for (const std::size_t i : grip.nodes->body().free())
      for (const std::size_t k : grip.nodes->body().free())
        border.entry(grip.first + i, grip.first + k) += turning[i][k];
  }
}

}  // namespace ixos
