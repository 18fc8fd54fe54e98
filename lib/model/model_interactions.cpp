// The interactions of a model, together and one by one.
#include <algorithm>
#include <utility>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "model/model.hpp"

namespace ixos {

void Model::add_interaction(std::unique_ptr<Interaction> term, const std::string& name) {
  interactions_.push_back(term.get());
  if (term->couples_anew()) moving_.push_back(term.get());
  interaction_of_.push_back(name);
  all_interactions_.reset();
  single_interactions_.clear();
  force_terms_.push_back({name, term.get()});
  std::string account = name;
  if (term->has_damage()) account = "damage of " + name;
  if (term->has_friction()) account = "friction of " + name;
  add_term(std::move(term), account);
}

const InteractionGroup& Model::all_interactions() const {
  if (!all_interactions_) all_interactions_ = std::make_unique<InteractionGroup>(mesh_, space_, interactions_, time_);
  return *all_interactions_;
}

const InteractionGroup& Model::interaction(const std::string& name) const {
  if (const auto known = single_interactions_.find(name); known != single_interactions_.end()) return known->second;
  std::vector<const Interaction*> own;
  for (std::size_t i = 0; i < interactions_.size(); ++i)
    if (interaction_of_[i] == name) own.push_back(interactions_[i]);
  if (own.empty()) throw InputError(no_such("interaction", name, interaction_names(), "The model has"));
  return single_interactions_.emplace(name, InteractionGroup(mesh_, space_, std::move(own), time_)).first->second;
}

std::vector<std::string> Model::interaction_names() const {
  std::vector<std::string> names;
  for (const std::string& name : interaction_of_)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

}  // namespace ixos
