/// Rates in a stage's balance.
#pragma once

namespace ixos {

/// How forces that depend on rates of strain enter the balance of a stage.
enum class RateForm {
  End,    ///< the force at the stage's end, its rates those of the stage's velocity row: collocation schemes
  Middle  ///< the deformation half way times the change of strain over the step: schemes in momentum form
};

}  // namespace ixos
