/// The names of contact elements.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mesh/enrichment/enrich.hpp"

namespace ixos {

/// Returns all contact elements with their names, which are those of CellTraits::contact, too.
const std::vector<std::pair<std::string, ContactElement>>& contact_elements();

}  // namespace ixos
