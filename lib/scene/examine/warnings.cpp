#include "scene/examine/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh/cell_place.hpp"

namespace ixos {
namespace {

using Facts = SceneFacts;
using Message = std::string;  ///< empty: nothing to warn of

/// Returns the message for the first surface that has one.
template <class Judge>
Message first_surface(const Facts& facts, const Judge& judge) {
  for (std::size_t i = 0; i < facts.surfaces.size(); ++i) {
    const SurfaceNumbers& numbers = facts.numbers.surfaces[i];
    const Message message = judge(numbers, facts.surfaces[i], facts.numbers.bodies[numbers.body]);
    if (!message.empty()) return "Interactions/" + numbers.name + ": " + message;
  }
  return "";
}
template <class Judge>
Message first_body(const Facts& facts, const Judge& judge) {
  for (const BodyNumbers& body : facts.numbers.bodies)
    if (const Message message = judge(body); !message.empty()) return "Materials/" + body.name + ": " + message;
  return "";
}
template <class Judge>
Message first_motion(const Facts& facts, const Judge& judge) {
  for (const Motion& motion : facts.motions)
    if (const Message message = judge(motion); !message.empty()) return motion.path + ": " + message;
  return "";
}

/// A front that is narrower than the distance of nodes moves from node to node by jumps.
Message cohesive_zone_against_faces(const Facts& facts) {
  return first_surface(facts, [&](const SurfaceNumbers& surface, const SurfaceFacts& own, const BodyNumbers&) {
    const double length = surface.face_length / own.order;
    if (surface.work == 0 || surface.is_electrode || length <= surface.cohesive_zone) return Message();
    return fmt::format(
        "the cohesive zone, {:.3g} L0, is shorter than the distance of the surface's nodes, {:.3g} L0: forces will "
        "oscillate with the mesh; use faces of at most {:.2g} L0, a richer Contact Element, or check the material's "
        "stiffness and the law's units",
        surface.cohesive_zone, length, surface.cohesive_zone * own.order / 2);
  });
}

/// Where two surfaces touch, the error of a sum over pairs of points grows quickly with their distance.
Message points_of_double_integral(const Facts& facts) {
  for (const DensePoints& own : facts.dense_points) {
    const double most = own.equilibrium_gap / 3, distance = own.face_length / own.on_a_face;
    if (distance <= most) continue;
    const double enough = std::ceil(own.face_length / most);
    return fmt::format(
        "Interactions/{}: the points of the double integral are {:.3g} L0 apart or more on half of the faces, but must "
        "be closer than a "
        "third of the equilibrium gap, {:.3g} L0, where the surfaces touch; use {}",
        own.name, distance, most,
        enough <= most_points_on_a_side ? fmt::format("{:.0f} Surface Points, or smaller faces", enough)
                                        : fmt::format("faces of at most {:.2g} L0", most_points_on_a_side * most));
  }
  return "";
}

/// A crease that ends inside a surface is none of the body's edges. The spline has a spike at its end, beside which the
/// nearest point of another surface jumps.
Message spline_with_open_creases(const Facts& facts) {
  if (facts.open_surfaces.empty()) return "";
  const OpenSurface& own = facts.open_surfaces.front();
  return fmt::format(
      "Interactions/{}: {} edges of the surface \"{}\" end inside it, but their faces meet at up to {:.3g} degrees "
      "(limit 30), so that the spline has kinks there: Newton's method may need many iterations; use smaller faces, or "
      "Smoothing \"Catmull-Rom\"",
      own.name, own.creases, own.side_set, own.angle * 180 / M_PI);
}

Message obstacle_of_another_period(const Facts& facts) {
  if (facts.uneven_periods.empty()) return "";
  const UnevenPeriod& own = facts.uneven_periods.front();
  return fmt::format(
      "Interactions/{}: the obstacle does not repeat with the mesh: at {}, on a periodic side, its gap is {:.4g} L0, "
      "at {}, the same place, {:.4g} L0, or its normal is another one; give both the same period, or take a plane "
      "along the period",
      own.name, point_in_words(own.place, facts.dimension), own.gap, point_in_words(own.partner, facts.dimension),
      own.partner_gap);
}

/// Beyond this, adhesion deforms the whole body like a liquid (the contact radius of Johnson, Kendall and Roberts
/// reaches that of the sphere at W/(E R) = 0.07).
Message elastic_length_against_body(const Facts& facts) {
  constexpr double limit = 0.05;
  return first_surface(facts, [&](const SurfaceNumbers& surface, const SurfaceFacts&, const BodyNumbers&) {
    if (surface.elastic_length <= limit * surface.thickness) return Message();
    return fmt::format(
        "the work of adhesion over Young's modulus is {:.3g} L0, {:.2g} times the body's thickness of {:.3g} L0 (limit "
        "{}): adhesion will deform the whole body; use a stiffer or larger body or a weaker law, or check their units",
        surface.elastic_length, surface.elastic_length / surface.thickness, surface.thickness, limit);
  });
}

Message wave_crossing_against_step(const Facts& facts) {
  constexpr double limit = 100;
  if (!facts.has_inertia) return "";
  return first_body(facts, [&](const BodyNumbers& body) {
    if (facts.step <= limit * body.crossing_time) return Message();
    return fmt::format(
        "the time step of {:.3g} T0 is {:.3g} times as long as a wave needs to cross the body, {:.3g} T0 (limit {}): "
        "inertia has no effect in such steps; use shorter steps or the scheme \"Static\", or check the density's unit",
        facts.step, facts.step / body.crossing_time, body.crossing_time, limit);
  });
}

Message wave_crossing_against_run(const Facts& facts) {
  if (!facts.has_inertia) return "";
  return first_body(facts, [&](const BodyNumbers& body) {
    if (facts.duration >= body.crossing_time) return Message();
    return fmt::format(
        "a wave needs {:.3g} T0 to cross the body, but the run lasts {:.3g} T0: what happens at one end does not reach "
        "the other; use a later Final Time, or check the units of the density and of Young's modulus (wave "
        "speed {:.3g} L0/T0)",
        body.crossing_time, facts.duration, body.wave_speed);
  });
}

/// A body that attraction accelerates from a distance crosses the range of the law in this time.
Message gap_crossing_against_step(const Facts& facts) {
  constexpr double limit = 3;
  if (!facts.has_inertia) return "";
  return first_surface(facts, [&](const SurfaceNumbers& surface, const SurfaceFacts& own, const BodyNumbers&) {
    if (own.moved || own.drive.held || surface.least_gap <= own.peak_gap) return Message();
    if (facts.step <= limit * surface.gap_crossing_time) return Message();
    return fmt::format(
        "the time step of {:.3g} T0 is {:.3g} times as long as the attracted body needs to cross the equilibrium gap, "
        "{:.3g} T0 (limit {}): impacts are not resolved; use a Time Step of at most {:.2g}, or adaptive steps with a "
        "Maximum Gap Ratio",
        facts.step, facts.step / surface.gap_crossing_time, surface.gap_crossing_time, limit,
        surface.gap_crossing_time);
  });
}

Message relaxation_against_step(const Facts& facts) {
  constexpr double limit = 1.0 / 3;
  for (std::size_t i = 0; i < facts.relaxation_times.size(); ++i) {
    const double time = facts.relaxation_times[i];
    if (facts.longest_step <= limit * time) continue;
    return fmt::format(
        "Materials/{}: steps of up to {:.3g} T0 are longer than a third of the shortest relaxation time, {:.3g} T0: "
        "with the History Update \"Second Order\" they may dissipate less than 0; use a {} of at most {:.2g}, or "
        "\"Backward Euler\"",
        facts.numbers.bodies[i].name, facts.longest_step, time, facts.adaptive ? "Maximum Time Step" : "Time Step",
        limit * time);
  }
  return "";
}

/// Aerogels to osmium, soft gels to diamond, weak liquids to tapes.
Message unknown_material(const Facts& facts) {
  if (!facts.scales) return "";
  const Scales& scale = *facts.scales;
  const double density = scale.stress * scale.time * scale.time / (scale.length * scale.length);
  const auto strange = [](const char* what, double value, double lowest, double highest, const char* unit) {
    if (value >= lowest && value <= highest) return Message();
    return fmt::format(
        "{} is {:.3g} {}, but known materials have {:.3g} to {:.3g} {}; check the value, which is in units of the list "
        "Units",
        what, value, unit, lowest, highest, unit);
  };
  Message body = first_body(facts, [&](const BodyNumbers& own) {
    Message heavy = facts.has_inertia ? strange("the density", own.density * density, 2, 3e4, "kg/m^3") : Message();
    return heavy.empty() ? strange("Young's modulus", own.modulus * scale.stress, 1, 2e12, "Pa") : heavy;
  });
  if (!body.empty()) return body;
  return first_surface(facts, [&](const SurfaceNumbers& surface, const SurfaceFacts&, const BodyNumbers&) {
    if (surface.work == 0) return Message();
    const Message work =
        strange("the work of adhesion", surface.work * scale.stress * scale.length, 1e-6, 1e4, "J/m^2");
    return work.empty() ? strange("the largest attraction", surface.peak_traction * scale.stress, 1, 1e11, "Pa") : work;
  });
}

double largest_size(const CharacteristicNumbers& numbers) {
  double size = 0;
  for (const BodyNumbers& body : numbers.bodies) size = std::max(size, body.size);
  return size;
}

Message motion_that_begins_with_a_jump(const Facts& facts) {
  if (facts.numbers.bodies.empty() || !facts.has_inertia) return "";
  const double size = largest_size(facts.numbers);
  return first_motion(facts, [&](const Motion& motion) {
    if (std::abs(motion.start) > 1e-6 * size)
      return fmt::format("the motion begins with a jump to {:.3g} L0; let it begin at 0", motion.start);
    return velocity_jump(facts.numbers, motion.start_jump, facts.initial_time);
  });
}

Message motion_that_jumps(const Facts& facts) {
  if (facts.numbers.bodies.empty() || !facts.has_inertia) return "";
  const double size = largest_size(facts.numbers);
  return first_motion(facts, [&](const Motion& motion) {
    Message jump = velocity_jump(facts.numbers, motion.velocity_jump, motion.jump_time);
    if (!jump.empty()) return jump;
    // Explicit schemes divide the step.
    if (facts.step > 0 && motion.range > 1e-6 * size && motion.in_one_step > 0.9 * motion.range &&
        facts.step < facts.duration / 1.5)
      return fmt::format(
          "{:.2g} of the whole motion of {:.3g} L0 happens in one step of {:.3g} T0 (limit 0.9); use a longer ramp or "
          "shorter steps",
          motion.in_one_step / motion.range, motion.range, facts.step);
    return Message();
  });
}

Message gap_without_attraction(const Facts& facts) {
  constexpr double patience = 10, weak = 1e-6;
  if (facts.loaded || facts.moves) return "";
  return first_surface(facts, [&](const SurfaceNumbers& surface, const SurfaceFacts& own, const BodyNumbers& body) {
    const double gap = surface.least_gap - own.drive.approach;
    if (surface.work == 0 || gap <= own.peak_gap) return Message();
    const double fall =
        std::sqrt(2 * (gap - own.peak_gap) * body.density * surface.thickness / std::max(own.attraction, 1e-300));
    const bool free = !own.drive.held && facts.has_inertia;
    if (free ? fall <= patience * facts.duration : own.attraction >= weak * surface.peak_traction) return Message();
    return fmt::format(
        "the surface comes no nearer than {:.3g} L0, where the attraction is {:.2g} of its largest value{}: nothing "
        "will happen; move the body or the obstacle nearer, or give it a velocity",
        gap, own.attraction / surface.peak_traction,
        free ? fmt::format("; to fall from there takes about {:.2g} T0, the run lasts {:.3g} T0", fall, facts.duration)
             : fmt::format(" (limit {})", weak));
  });
}

Message no_way_to_bend(const Facts& facts) {
  constexpr double share = 0.5, slender = 4;
  return first_surface(facts, [&](const SurfaceNumbers&, const SurfaceFacts& own, const BodyNumbers& body) {
    if (own.single_layer < share || body.size < slender * own.layer_thickness) return Message();
    return fmt::format(
        "{:.0f} % of the surface (limit {:.0f} %) has one layer of cells behind it, {:.3g} L0 thick on a body of "
        "{:.3g} L0: linear cells are far too stiff in bending; use at least 4 layers, or \"Enhanced\" elements with "
        "Q1C1",
        100 * own.single_layer, 100 * share, own.layer_thickness, body.size);
  });
}

/// The bending energy of the mesh's own cells shows both kinds of locking.
Message cells_that_lock(const Facts& facts) {
  constexpr double volumetric_limit = 1.02, bending_limit = 1.3;
  const bool has_single_layer = !no_way_to_bend(facts).empty();
  for (std::size_t i = 0; i < facts.bending.size(); ++i) {
    const BodyBending& own = facts.bending[i];
    const CellBending& cells = own.cells;
    const std::string& name = facts.numbers.bodies[i].name;
    if (own.is_volumetric && cells.body > volumetric_limit)
      return fmt::format(
          "Materials/{}: Poisson's ratio is {:.4g} (limit {}) and the cells are \"Standard\", which lock: one of them "
          "is {:.3g} times as stiff in bending as the material, {} layers of them may be {:.3g} times as stiff (limit "
          "{}), and more where the strains are local; use the Element Formulation \"Mean Dilatation\" or \"Enhanced\"",
          name, own.poissons_ratio, nearly_incompressible, cells.cell, cells.layers, cells.body, volumetric_limit);
    if (!own.is_volumetric && !has_single_layer && cells.body > bending_limit)
      return fmt::format(
          "Materials/{}: the body is slender, and {} layer(s) of linear cells, {:.2g} times as long as thick, are "
          "{:.3g} times as stiff in bending as the material (limit {}): one cell locks by {:.3g}, n layers by a share "
          "of 1/n^2 of the excess; use more layers, shorter cells, \"Enhanced\" elements, or Cell Order 2",
          name, cells.layers, cells.aspect, cells.body, bending_limit, cells.cell);
  }
  return "";
}

/// Linear triangles, tetrahedra, prisms and pyramids.
Message linear_simplices(const Facts& facts) {
  for (std::size_t i = 0; i < facts.bending.size(); ++i) {
    const BodyBending& own = facts.bending[i];
    if (own.stiff_cells.empty()) continue;
    return fmt::format(
        "Materials/{}: linear {} cells are too stiff in bending, and with a Poisson's ratio from 0.4 on (it is {:.4g}) "
        "in "
        "other deformations, too; use Cell Order 2",
        facts.numbers.bodies[i].name, own.stiff_cells, own.poissons_ratio);
  }
  return "";
}

/// A twisted bar of such cells, elements-twist in docs/results/elements.md, shows what is wrong.
Message quadratic_tetrahedra(const Facts& facts) {
  constexpr double limit = 0.49;
  for (std::size_t i = 0; i < facts.bending.size(); ++i) {
    const BodyBending& own = facts.bending[i];
    if (!own.has_tetrahedra || own.poissons_ratio < limit) continue;
    return fmt::format(
        "Materials/{}: Poisson's ratio is {:.6g} (limit {}) and the cells are quadratic tetrahedra of the Element "
        "Formulation \"Standard\": their forces are some percent too large, their pressure is far too large, and both "
        "grow towards 1/2; use \"Mean Dilatation\"",
        facts.numbers.bodies[i].name, own.poissons_ratio, limit);
  }
  return "";
}

Message bond_that_never_forms(const Facts& facts) {
  return first_surface(facts, [](const SurfaceNumbers& surface, const SurfaceFacts& own, const BodyNumbers&) {
    if (!own.never_bonds) return Message();
    return fmt::format(
        "the surface begins at a gap of {:.3g} L0, beyond the range of its law, {:.3g} L0: a bond that begins out of "
        "range never forms, and the surface only repels; set Bond on Touch, or let the surface begin at the obstacle",
        surface.least_gap, own.range);
  });
}

Message oblique_pull_without_friction(const Facts& facts) {
  constexpr double limit = 0.1;
  return first_surface(facts, [&](const SurfaceNumbers& surface, const SurfaceFacts& own, const BodyNumbers&) {
    if (own.moved || own.has_friction) return Message();
    for (const Pull& pull : own.drive.pulls) {
      const double across = std::max(pull.away, pull.towards);
      if (pull.along <= limit * across || (pull.away == 0 && surface.least_gap > own.peak_gap)) continue;
      return fmt::format(
          "{} acts at {:.0f} degrees to the obstacle (limit {:.0f}), but there is no friction: the surface will slide "
          "freely; act along the obstacle's normal, hold the body against sliding, or give the interaction a Friction",
          pull.path, std::atan2(across, pull.along) * 180 / M_PI, std::atan2(1.0, limit) * 180 / M_PI);
    }
    return Message();
  });
}

/// Two laws before one obstacle stand for one physical law; a threshold from a part of it is rarely meant.
Message friction_of_one_law(const Facts& facts) {
  return first_surface(facts, [&](const SurfaceNumbers&, const SurfaceFacts& own, const BodyNumbers&) {
    if (own.uncounted.empty()) return Message();
    return fmt::format(
        "the threshold of the friction follows the law of this list alone, and \"{}\" acts before the same obstacle, "
        "too; let the list whose law carries the load have the friction, or use the type \"Constant Stress\"",
        own.uncounted);
  });
}

/// A stiff beam before an electrode may be meant to stay away from it; a soft body is pulled on to it.
Message attraction_without_repulsion(const Facts& facts) {
  constexpr double limit = 1e-4;
  return first_surface(facts, [&](const SurfaceNumbers& surface, const SurfaceFacts& own, const BodyNumbers& body) {
    if (own.opposed || surface.peak_traction <= limit * body.modulus) return Message();
    return fmt::format(
        "the law only attracts, and no other interaction of the side set repels: nothing stops the surface at the "
        "obstacle (largest attraction {:.2g} of Young's modulus, limit {}); add an interaction of this side set with "
        "the Law \"Penalty\" or \"Log Barrier\", or use a law that repels, too",
        surface.peak_traction / body.modulus, limit);
  });
}

constexpr const char* start_jump = "jump at the start";

constexpr WarningKind<SceneFacts> kinds[] = {
    {"material", unknown_material},
    {"elastic length", elastic_length_against_body},
    {"cohesive zone", cohesive_zone_against_faces},
    {"double integral", points_of_double_integral},
    {"coarse spline", spline_with_open_creases},
    {"period", obstacle_of_another_period},
    {"wave and run", wave_crossing_against_run},
    {"wave and step", wave_crossing_against_step},
    {"gap and step", gap_crossing_against_step},
    {"relaxation", relaxation_against_step},
    {start_jump, motion_that_begins_with_a_jump},
    {"jump", motion_that_jumps},
    {"no attraction", gap_without_attraction},
    {"no repulsion", attraction_without_repulsion},
    {"bond", bond_that_never_forms},
    {"bending", no_way_to_bend},
    {"locking", cells_that_lock},
    {"linear simplices", linear_simplices},
    {"quadratic tetrahedra", quadratic_tetrahedra},
    {"friction of one law", friction_of_one_law},
    {"no friction", oblique_pull_without_friction},
};

}  // namespace

std::vector<Warning> scene_warnings(const SceneFacts& facts) { return warnings_of(facts, kinds); }

std::string velocity_jump(const CharacteristicNumbers& numbers, double jump, double time) {
  constexpr double fast = 0.02;
  double speed = 0;
  for (const BodyNumbers& body : numbers.bodies) speed = std::max(speed, body.wave_speed);
  if (jump <= fast * speed) return "";
  return fmt::format(
      "the velocity of the motion jumps by {:.3g} L0/T0 at t = {:.6g} T0, {:.2g} of the wave speed (limit {}); let "
      "it rise over some time, for example by a Rate Ramp",
      jump, time, jump / speed, fast);
}

bool is_about_start(const Warning& warning) { return warning.name == start_jump; }

}  // namespace ixos
