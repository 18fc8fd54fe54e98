/// What the schemes that balance momentum over a step have in common.
#pragma once
#include "time/table.hpp"

namespace ixos {

/// M (v - v_n) + C (u - u_n) + dt F = dt F_ext with u - u_n = dt (v_n + v)/2; the rules and the load are left to fill
/// in.
Stage momentum_form_stage();

/// The table with that one stage.
Table momentum_form_table(const char* name, const Stage& stage);

}  // namespace ixos
