// The life of a model's terms through steps, and what they keep in checkpoints.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/agreement.hpp"
#include "model/model.hpp"
#include "term/keeps_sight.hpp"

namespace ixos {

void Model::initialize(const KnownState& start) {
  for (const NamedTerm& named : terms_) named.term->initialize(start);
}

void Model::begin_step(const KnownState& start, double time, double dt) {
  for (const NamedTerm& named : terms_) named.term->begin_step(start, time, dt);
}

void Model::begin_stage(const StageStart& start) {
  for (const NamedTerm& named : terms_) named.term->begin_stage(start);
}

std::vector<double> Model::accept(const AcceptedStep& step) {
  std::vector<double> work(dissipation_names_.size(), 0.0);
  for (const NamedTerm& named : terms_) {
    const double dissipated = named.term->accept(step);
    if (named.account >= 0) work[static_cast<std::size_t>(named.account)] += dissipated;
  }
  if (!work.empty()) space_.sum(work.data(), static_cast<int>(work.size()));
  return work;
}

double Model::history_error(const double* from, const double* to, double dt) const {
  if (!has_viscoelasticity()) return 0;
  double sums[2] = {0, 0};
  for (const Body& body : bodies_) {
    if (body.viscoelasticity == nullptr) continue;
    double modulus = body.material.law->lame().mu;
    for (const MaxwellBranch& branch : body.material.branches) modulus += branch.modulus;
    const std::array<double, 2> own = body.viscoelasticity->squared_error(from, to, dt);
    sums[0] += own[0] / (modulus * modulus);
    sums[1] += own[1];
  }
  space_.sum(sums, 2);
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  double size = 0;
  for (std::size_t i = 0; i < d; ++i) {
    double highest = -std::numeric_limits<double>::infinity(), lowest = -highest;
    for (std::size_t node = 0; node < static_cast<std::size_t>(mesh_.owned_nodes); ++node) {
      if (mesh_.is_derivative(node)) continue;
      highest = std::max(highest, mesh_.coordinates[node * d + i]);
      lowest = std::min(lowest, mesh_.coordinates[node * d + i]);
    }
    size = std::max(size, space_.maximum(highest) + space_.maximum(-lowest));
  }
  return size * std::sqrt(sums[0] / sums[1]);
}

std::vector<HistoryStress> Model::history_stresses() const {
  std::vector<HistoryStress> stresses;
  std::vector<double> squares;
  std::vector<double> moduli;
  for (const Body& body : bodies_) {
    if (body.viscoelasticity == nullptr) continue;
    const BranchSquares& own = body.viscoelasticity->last_squares();
    HistoryStress stress;
    stress.update = body.material.history_update;
    for (const MaxwellBranch& branch : body.material.branches) stress.times.push_back(branch.time);
    stress.branches = own.branches;
    stress.branches.resize(stress.times.size(), 0.0);  // no step was accepted yet
    squares.insert(squares.end(), stress.branches.begin(), stress.branches.end());
    squares.insert(squares.end(), {own.sum, own.strain});
    moduli.push_back(body.material.law->lame().mu);
    stresses.push_back(std::move(stress));
  }
  if (stresses.empty()) return stresses;
  space_.sum(squares.data(), static_cast<int>(squares.size()));
  auto square = squares.begin();
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    for (double& branch : stresses[i].branches) branch = std::sqrt(*square++);
    stresses[i].sum = std::sqrt(*square++);
    stresses[i].all = stresses[i].sum + moduli[i] * std::sqrt(*square++);
  }
  return stresses;
}

bool Model::has_histories() const {
  return std::any_of(terms_.begin(), terms_.end(), [](const NamedTerm& named) { return named.term->has_history(); });
}

/// Returns the name of a term's section. That of a history counts the histories of the same name only, so that it is
/// found in a scene with other terms.
std::string Model::section_of(std::size_t term) const {
  if (!terms_[term].term->has_history()) return "term " + std::to_string(term + 1) + ", " + terms_[term].name;
  const auto count = std::count_if(
      terms_.begin(), terms_.begin() + static_cast<std::ptrdiff_t>(term) + 1,
      [&](const NamedTerm& other) { return other.term->has_history() && other.name == terms_[term].name; });
  return "history " + std::to_string(count) + " of " + terms_[term].name;
}

void Model::transfer(std::size_t term, Record& record) {
  const Record::Section section(record, section_of(term));
  if (!record.loading()) return terms_[term].term->transfer(record);
  // A term's numbers may fit on some ranks only. It throws after its last collective call.
  together<InputError>(space_.comm(), [&] { terms_[term].term->transfer(record); });
}

void Model::transfer(Record& record) {
  for (std::size_t i = 0; i < terms_.size(); ++i)
    if (terms_[i].term->has_state()) transfer(i, record);
}

void Model::transfer_histories(Record& record) {
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    if (!record.has_section(section_of(i))) continue;
    if (terms_[i].term->has_history()) {
      transfer(i, record);
    } else if (auto* const keeper = dynamic_cast<KeepsSight*>(terms_[i].term.get())) {
      const Record::Section section(record, section_of(i));
      keeper->transfer_sight(record);
    }
  }
}

}  // namespace ixos
