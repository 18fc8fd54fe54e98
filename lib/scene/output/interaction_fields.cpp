#include "scene/output/interaction_fields.hpp"

namespace ixos {

std::vector<OutputField> interaction_fields(const std::string& name) {
  const auto group = [name](FieldFrame& frame) { return frame.report().interaction(name); };
  std::vector<OutputField> fields;
  fields.push_back({"gap_" + name,
                    "Distance of a surface node from the obstacle of this interaction; NaN away from its surface.",
                    "L0", FieldShape::Scalar});
  fields.back().nodal = [=](FieldFrame& frame) { return scalar_of_owned(frame.model(), group(frame).gap()); };
  fields.push_back({"normal_" + name,
                    "Unit normal of the obstacle of this interaction, away from it, at its point nearest to a "
                    "surface node; zero away from the surface.",
                    "-", FieldShape::Axes});
  fields.back().nodal = [=](FieldFrame& frame) { return vector_of_owned(frame.model(), group(frame).normal()); };
  fields.push_back({"traction_" + name,
                    "Traction of this interaction on the body, nodal force over nodal reference area of its surface.",
                    "E0", FieldShape::Axes});
  fields.back().nodal = [=](FieldFrame& frame) { return vector_of_owned(frame.model(), group(frame).traction()); };
  fields.push_back({"pressure_" + name,
                    "Part of this traction along the obstacle's normal; positive: the obstacle pushes.", "E0",
                    FieldShape::Scalar});
  fields.back().nodal = [=](FieldFrame& frame) { return scalar_of_owned(frame.model(), group(frame).pressure()); };
  fields.push_back(
      {"damage_" + name,
       "Damage of the bonds of this interaction, 0 for whole ones and 1 for broken ones: a nodal mean over "
       "its surface, zero away from it. Only with the law Bilinear Damage.",
       "-", FieldShape::Scalar});
  fields.back().needs = "the law \"Bilinear Damage\" in the interaction \"" + name + "\"";
  fields.back().present = [name](const Model& model) { return has(model, name, SurfaceNumber::Damage); };
  fields.back().nodal = [=](FieldFrame& frame) {
    return scalar_of_owned(frame.model(), group(frame).mean(SurfaceNumber::Damage));
  };
  const auto rubs = [name](const Model& model) { return has_friction(model, name); };
  fields.push_back({"friction_" + name, "Part of this traction that is friction: it resists slip along the obstacle.",
                    "E0", FieldShape::Axes, false, "friction of this interaction", rubs});
  fields.back().nodal = [=](FieldFrame& frame) { return vector_of_owned(frame.model(), group(frame).friction()); };
  const auto add_number = [&](const char* stem, const char* sentence, const char* unit, SurfaceNumber number) {
    fields.push_back({stem + name, sentence, unit, FieldShape::Scalar, false, "friction of this interaction", rubs});
    fields.back().nodal = [=](FieldFrame& frame) { return scalar_of_owned(frame.model(), group(frame).mean(number)); };
  };
  add_number("slip_", "Length of the way that the surface has slid along this obstacle, without the elastic slip.",
             "L0", SurfaceNumber::Slip);
  add_number("sliding_",
             "1 where the surface slid along this obstacle in the last step, 0 where it stuck or was apart: a nodal "
             "mean. With Smoothed friction 1 where it was faster than Slip Speed.",
             "-", SurfaceNumber::Sliding);
  add_number("dissipated_", "Energy that friction along this obstacle has dissipated per reference area.", "E0 L0",
             SurfaceNumber::Dissipated);
  return fields;
}

}  // namespace ixos
