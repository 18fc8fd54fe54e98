/// The numbers that advice, accuracy and comparisons are tuned by: one table, so that a change of one is seen beside
/// the others. Numbers of formats, and limits that a message states, stand where they are used.
#pragma once
#include <array>
#include <cstddef>

namespace ixos::tuning {

// Quantities of a run.
inline constexpr double at_rest = 0.01;    ///< part of the largest kinetic energy below which a body has stopped
inline constexpr double near_end = 0.05;   ///< part of the window that a run may miss at its end
inline constexpr double same_time = 1e-9;  ///< part of a run's duration

// Orders and errors of a sequence of runs with finer and finer settings.
inline constexpr double least_order = 0.7, largest_order = 6;
inline constexpr double trusted_order = 2;     ///< largest order that counts if three points alone give it
inline constexpr double agreement = 0.2;       ///< part of the order by which two orders may differ
inline constexpr double confirmed_part = 0.5;  ///< uncertainty over the extrapolated error, of a confirmed order
inline constexpr double single_part = 2;       ///< the same, of an order that three points alone give
inline constexpr double bound_factor = 1.5;    ///< of a bound by differences
inline constexpr double power_of_earlier = 2;  ///< of the size, with which a difference before the last two falls
inline constexpr double slowest = 0.4;         ///< power of the size with which differences fall at least
inline constexpr double rounding = 1e-13;      ///< part of a value below which a difference is rounding

// Steps for an accuracy.
inline constexpr double coarse_accuracy = 0.01;  ///< that the limits of a first run are made for
inline constexpr double coarse_gap_ratio = 2;
inline constexpr double coarse_steps = 25;  ///< of a run, at least
inline constexpr double coarse_newton = 1e-6;
inline constexpr double least_newton = 1e-11;  ///< the default of a scene: all that remains is rounding
inline constexpr std::size_t least_runs = 3;   ///< two may agree by coincidence
inline constexpr std::size_t most_runs = 10;
inline constexpr int most_finer_meshes = 4;
inline constexpr int most_failed_runs = 3;
inline constexpr double refinement = 1.25;  ///< least ratio of the mean steps of runs that count as different
inline constexpr double progress = 0.7;     ///< largest ratio of changes that counts as an improvement
inline constexpr int most_without_progress = 2;

// Errors of a comparison, and what it recommends.
inline constexpr double negligible = 1e-9;       ///< a column is as good as zero below this part of its measure
inline constexpr double too_uncertain = 0.5;     ///< a measure is blank if the reference's own error exceeds this
inline constexpr double allowed_part = 1.0 / 3;  ///< of a tolerance, that the reference's own error may be

// Settings that advice varies.
inline constexpr double fewest_steps = 30;
inline constexpr int coarser_steps = 4, finer_steps = 5;    ///< levels of the time step about the scene's own
inline constexpr int coarser_meshes = 3, finer_meshes = 3;  ///< levels of the mesh about the scene's own
inline constexpr int most_cells_along_an_edge = 20000;
inline constexpr int fewest_cells = 2;           ///< along an edge, in steps of the number: one cell cannot bend
inline constexpr double loose_tolerance = 1e-8;  ///< of Newton's method; above it, its error is measured
inline constexpr int few_points = 3, default_points = 5, default_points_enriched = 8, most_points = 64;
inline constexpr double perturbation_size = 1e-10;

// Its budget.
inline constexpr double times_the_scene = 8;  ///< the budget over the expected cost of the scene
inline constexpr double least_budget = 60;    ///< seconds; a process takes a part of one to start
/// Power of the number of cells in the expected cost of the scene: less than that of large runs, because a part of the
/// cost of the coarsest run does not grow.
inline constexpr double budget_power = 0.85;
/// A run may take this much more processor time than the budget has left, before it is ended.
inline constexpr double grace_seconds = 1;

// Its model of costs.
/// Weight of the default powers, in samples that differ by a factor e. It decides where the samples do not.
inline constexpr double weight_of_defaults = 0.02;
/// Equal runs differ by this part of their time, and by this many seconds.
inline constexpr double time_accuracy = 0.1, time_noise = 0.05;
inline constexpr double least_cost_power = 0.3, largest_step_power = 1.3, largest_dof_power = 2.5;
/// The steps of an adaptive run grow as its tolerance falls, with this power: that of a scheme of second order.
inline constexpr double adaptive_power = 1.0 / 3;
inline constexpr double other_branch = 100;  ///< levels that a run of another branch counts as farther

// Its model of errors.
inline constexpr double order_of_schemes = 2;
/// The part of an uncertainty that is left if one more level confirms the order of three.
inline constexpr double hoped_part = 0.25;
/// Error of the finest run over its last change, of step or mesh: a third with second order, times 1.5.
inline constexpr double part_of_change = 0.5;
inline constexpr double doubted_part = 0.35;  ///< of the distance of another branch, by which two sizes may be wrong
/// Powers of the cell length with which errors are expected to fall, and the gain by a higher order.
inline constexpr double least_cell_power = 1, largest_cell_power = 2, gain_of_order = 0.5;

// Sensitivity to a perturbation.
inline constexpr double predictable = 1e-6;  ///< ten thousand times the perturbation
inline constexpr double least_chaotic = 1e-5;
inline constexpr double chaotic_part = 1.0 / 3;  ///< of the tolerance, that the change by a perturbation may be
/// Change by the perturbation below which finer runs are not perturbed, too: they will not amplify it as much as a
/// tolerance needs.
inline constexpr double calm = 1e-8;

// Its search.
inline constexpr std::size_t most_rounds = 100;
inline constexpr std::size_t least_points_of_a_line = 3;  ///< that settings are recommended by
inline constexpr std::size_t most_points_of_a_line = 3;   ///< of one that moves with the base
inline constexpr std::size_t far_from_base = 2;  ///< levels of a mesh on which errors of the step are measured anew
/// Largest part of the tolerance that an error may be to count as known at a coarse base: it may be misjudged there by
/// a factor of ten or so.
inline constexpr double negligible_part = 0.05;
inline constexpr long most_failures_of_a_level = 2;  ///< before the search gives up
inline constexpr double helpful = 0.9;          ///< largest part of an error that a refinement which helps leaves of it
inline constexpr double part_of_mesh = 0.5;     ///< of the tolerance, that the mesh may use up
inline constexpr double part_of_budget = 0.25;  ///< of what is left, that the trial of other elements may take
inline constexpr double worthwhile_cells = 1.2;  ///< cost with other elements over that with the present ones, at most

// Its improvements and forecasts.
inline constexpr double times_the_plan = 8;  ///< the cost of all runs over that of the recommended run
inline constexpr double promising = 2;  ///< accuracy over that of the scene's own, of trials that others do not hold up
inline constexpr double worthwhile_trial = 0.5;  ///< cost of a trial over what it may save in one run
inline constexpr double saving_of_a_choice = 0.25;
/// Accuracy of other elements or schemes over the scene's own for which finer levels are tried.
inline constexpr double least_gain = 1.3;
inline constexpr double least_share = 0.25;  ///< of the tolerance, that counts as left for a direction
inline constexpr std::array<double, 5> other_tolerances{10, 3, 1, 1.0 / 3, 0.1};
inline constexpr std::size_t extrapolated_levels = 3;
/// Costs of the runs that lead to settings, over that of these settings: each refinement about halves them.
inline constexpr double runs_on_the_way = 3;
/// Share of the tolerance by which two and three dimensions may differ on the coarsest mesh, where a scene is plane.
inline constexpr double most_of_plane = 0.01;

}  // namespace ixos::tuning
