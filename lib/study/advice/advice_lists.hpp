/// Settings of all bodies or all interactions of a scene together.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "study/common/study_run.hpp"

namespace ixos {

/// Returns the names of the sublists whose paths a setting can name.
std::vector<std::string> list_names(const Teuchos::ParameterList& lists);

/// Returns the setting of a parameter in all of these lists: "PATH/NAME/SETTING".
Assignments in_all(const std::string& path, const std::vector<std::string>& names, const std::string& setting);

/// Returns whether a text has the same value in all of these lists, and that value is one of the words.
bool all_are(const Teuchos::ParameterList& lists, const std::vector<std::string>& names, const char* entry,
             const std::vector<std::string>& words);

}  // namespace ixos
