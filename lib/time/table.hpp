/// A one-step scheme as a table.
#pragma once
#include <string>
#include <vector>

#include "fem/rule.hpp"
#include "time/row.hpp"

namespace ixos {

/// One stage solves for one displacement u_s:
///   (1/dt^2) M inertia(u_s) + (1/dt) C damping(u_s) + elastic rule + interaction rule = 0,
/// the rules on the segment from the step's start to u_s. Then dt v_s = velocity(u_s), dt^2 a_s = acceleration(u_s).
struct Stage {
  double end = 1;  ///< time of u_s in steps from the step's start
  Row velocity;
  Row acceleration;
  Row inertia;  ///< dt^2 times what M multiplies
  Row damping;  ///< dt times what C multiplies
  Rule elastic;
  Rule interaction;
};

/// How the acceleration at the end of a step is found.
enum class Closing {
  Kinematic,  ///< from the last stage's row, which satisfies the balance at the end of the step
  Collocate   ///< from M a = -C v - f at the end of the step, where it is asked for; momentum-form schemes, whose
              ///< recursion rings
};

/// How the damping work of a step is summed (the column D of the energy balance).
struct DampingWork {
  enum class Form {
    Increment,  ///< du . C du/dt
    EndMean,    ///< du . C (v_n + v)/2
    Stages      ///< dt sum_i weights_i v_i . C v_i over the known states and the end
  };
  Form form = Form::Increment;
  std::vector<double> weights;
};

/// Where Newton's iteration starts: u_k + h v_k + h^2/2 a_k, cut after the first, second or third part, from the latest
/// known state k, h to the stage's end. Always clipped to admissible gaps.
enum class Predictor { LastDisplacement, ConstantVelocity, ConstantAcceleration };

struct Table {
  std::string name;
  std::vector<Stage> stages;
  Closing closing = Closing::Kinematic;
  DampingWork damping_work;
  Predictor predictor = Predictor::LastDisplacement;  ///< the one that takes the fewest iterations at an impact
};

/// Throws std::invalid_argument, with the stage and the row, unless rule weights sum to 1 and the velocity,
/// acceleration, inertia and damping rows reproduce u = 1, t and t^2 (inertia and damping rows: the mean of u'' and u'
/// that the rules stand for; for t^2 the damping row may be off the stage's end, as u'(mean)).
void check(const Table& table);

}  // namespace ixos
