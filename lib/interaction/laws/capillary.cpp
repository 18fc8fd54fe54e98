#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"
#include "interaction/piecewise_law.hpp"

namespace ixos {
namespace {

enum class Constants { Humidity, Meniscus };

struct Parameters {
  Constants constants = Constants::Humidity;
  double tension = 0, humidity = 0, kelvin = 0, angle = 0;
  double pressure = 0, height = 0;
  double smoothing = 0.2;
};

}  // namespace

LawEntry capillary_law() {
  Options<Parameters> options;
  options
      .choose_one("Constants", &Parameters::constants,
                  {{"Humidity", Constants::Humidity}, {"Meniscus", Constants::Meniscus}},
                  {{"Humidity", {"Surface Tension", "Relative Humidity", "Kelvin Pressure", "Contact Angle"}},
                   {"Meniscus", {"Laplace Pressure", "Meniscus Height"}}},
                  "The constants that a scene gives. Humidity: Surface Tension, Relative Humidity, Kelvin Pressure and "
                  "Contact Angle. Meniscus: Laplace Pressure and Meniscus Height.")
      .require("Surface Tension", &Parameters::tension,
               "Surface tension gamma of the liquid [E0 L0]: 0.07199 N/m for water at 25 degrees Celsius.",
               greater_than(0))
      .require("Relative Humidity", &Parameters::humidity, "Pressure of the vapour over that of saturation, H [-].",
               greater_and_less_than(0, 1))
      .require(
          "Kelvin Pressure", &Parameters::kelvin,
          "p_K = R T/V_m: gas constant times temperature over the molar volume of the liquid [E0]. For water at 25 "
          "degrees Celsius 137.2 MPa. The Laplace pressure is -p_K ln H.",
          greater_than(0))
      .add("Contact Angle", &Parameters::angle, "Contact angle of the liquid on both surfaces [degrees].",
           at_least_and_less_than(0, 90))
      .require("Laplace Pressure", &Parameters::pressure, "Pressure of the air less that of the liquid, p_L [E0].",
               greater_than(0))
      .require("Meniscus Height", &Parameters::height, "Gap d_m up to which liquid condenses [L0].", greater_than(0))
      .add("Smoothing", &Parameters::smoothing,
           "Ratio w/d_m [-]: the attraction ends by a cubic polynomial from d_m - w to d_m + w. The work of adhesion "
           "does not depend on it.",
           greater_than_and_at_most(0, 1));
  return {"Capillary",
          "T(r) = -p_L up to the height of the meniscus, where it ends smoothly: the Laplace pressure of condensed "
          "liquid in equilibrium with its vapour. It only attracts: another interaction of the side set has to repel.",
          "Israelachvili 2011", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const bool humidity = p.constants == Constants::Humidity;
            const double pressure = humidity ? -p.kelvin * std::log(p.humidity) : p.pressure;
            const double height = humidity ? 2 * p.tension / pressure * std::cos(p.angle * M_PI / 180) : p.height;
            const double ramp = p.smoothing * height;
            check_derived(node,
                          humidity ? "Surface Tension, Relative Humidity, Kelvin Pressure and Smoothing"
                                   : "Laplace Pressure, Meniscus Height and Smoothing",
                          {{"Laplace pressure", pressure},
                           {"height of the meniscus", height},
                           {"largest slope 3 p_L/(4 w)", 0.75 * pressure / ramp}});
            return gap_law(constant_attraction(pressure, height, ramp));
          }};
}

}  // namespace ixos
