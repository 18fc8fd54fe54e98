#include "term/term.hpp"

#include "state/history.hpp"

namespace ixos {

void Term::add_histories(std::vector<TermHistory>& all) const {
  all.push_back(create_history());
  for (const Term* inner : inside()) inner->add_histories(all);
}

TermHistory Term::create_history() const { return {}; }

TermHistories lone_histories(Term& term) {
  std::size_t next = 0;
  term.take_slot(next);
  std::vector<TermHistory> all;
  term.add_histories(all);
  return TermHistories(std::move(all));
}

}  // namespace ixos
