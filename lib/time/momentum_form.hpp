/// The common part of the schemes that balance momentum over a step.
#pragma once
#include "time/table.hpp"

namespace ixos {

/// Returns M (v - v_n) + C (u - u_n) + dt F = dt F_ext with u - u_n = dt (v_n + v)/2; the caller fills in the rules and
/// the load.
Stage momentum_form_stage();

/// Returns the table with that one stage.
Table momentum_form_table(const char* name, const Stage& stage);

}  // namespace ixos
