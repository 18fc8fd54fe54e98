/// Whether a number of a run can be predicted.
#pragma once

namespace ixos {

/// Sensitive: a perturbation grows much, but not to the tolerance. Chaotic: it grows to a third of the tolerance or
/// more, so that no refinement makes the number converge.
enum class Predictability { Predictable, Sensitive, Chaotic };

struct Sensitivity {
  double change = 0;  ///< of the number, relative to itself
  Predictability kind = Predictability::Predictable;
};

/// Judges the values of two runs whose scenes differ by 1e-10 in relation. A change of at most 1e-6 is predictable; one
/// of at most 1e-5 is not called chaotic, however small the tolerance is. NaN counts as chaotic.
Sensitivity sensitivity(double value, double perturbed, double tolerance);

}  // namespace ixos
