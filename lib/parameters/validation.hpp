/// Checks of a scene against the list of valid parameters.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

#include "parameters/parameter_entries.hpp"

namespace ixos {

/// Conventions of a list of valid parameters, beside names, default values, validators and documentation:
/// - a sublist named any_name stands for any number of sublists whose names the user chooses;
/// - a sublist marked by mark_free_form() takes anything: another library checks it;
/// - a sublist marked by mark_like_root() has, beside its own parameters, the lists of the outermost list: what they
///   become part of checks them;
/// - a string with the validator choice_of() chooses among sublists: only the chosen one is filled in with defaults;
/// - a string with the validator exclusive_choice_of() chooses what else the list holds: what belongs to other words is
///   refused, and not filled in; such a choice may itself belong to a word of a choice before it;
/// - a string whose default is `required`, and a double whose default is NaN, must be given.
extern const char* const required;
void mark_free_form(Teuchos::ParameterList& list);
bool is_free_form(const Teuchos::ParameterList& valid);
void mark_like_root(Teuchos::ParameterList& list);
bool is_like_root(const Teuchos::ParameterList& valid);
/// Returns the valid list that has the sublists of `valid`: that itself, or `root`, the outermost one.
const Teuchos::ParameterList& lists_of(const Teuchos::ParameterList& valid, const Teuchos::ParameterList& root);
/// Adds a number that must be given to a valid list. Its default is NaN, which is in no range.
void set_required(Teuchos::ParameterList& valid, const std::string& name, const std::string& documentation,
                  const Teuchos::RCP<const Teuchos::ParameterEntryValidator>& validator);
/// Returns whether this entry of a valid list must be given.
bool is_required(const Teuchos::ParameterEntry& entry);

/// Returns the user's list with every default filled in, and every int that stands for a double converted. Throws
/// InputError whose message names the list path, the offending value, what is allowed and the nearest valid name.
Teuchos::ParameterList validated(const Teuchos::ParameterList& user, const Teuchos::ParameterList& valid);

/// Removes from a user's list what belongs to other words than the one that the entry `choice` says, if that is an
/// exclusive choice of the valid list.
void discard_left_out(Teuchos::ParameterList& user, const Teuchos::ParameterList& valid, const std::string& choice);

/// Returns the valid list for sublist `name` of a list described by `valid`: null in a free-form list. Throws
/// InputError, with `path` for the place, if no sublist has that name.
const Teuchos::ParameterList* valid_sublist(const Teuchos::ParameterList& valid, const std::string& name,
                                            const std::string& path);

/// Returns the valid entry `name`. Throws InputError.
const Teuchos::ParameterEntry& valid_entry(const Teuchos::ParameterList& valid, const std::string& name,
                                           const std::string& path);

}  // namespace ixos
