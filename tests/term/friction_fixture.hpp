/// Surfaces that slide along obstacles, for tests of friction.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "interaction/catalogue.hpp"
#include "interaction/van_der_waals.hpp"
#include "parameters/validation.hpp"
#include "support/by_hand.hpp"
#include "support/solids.hpp"
#include "support/tangents.hpp"
#include "term/wall/friction_term.hpp"

namespace ixos::test {

enum class Shape { Flat, Round, Cavity, Waves };
inline const std::pair<Shape, const char*> shapes[] = {
    {Shape::Flat, "wall"}, {Shape::Round, "sphere"}, {Shape::Cavity, "cavity"}, {Shape::Waves, "vertical gap"}};

/// Returns an obstacle 0.27 below the surface, which lies at a height of 0.3; the waves go up and down from there.
inline std::shared_ptr<const Obstacle> obstacle(Shape shape, int dimension) {
  HalfSpace wall;
  wall.normal = dimension == 2 ? std::array<double, 3>{0, 1, 0} : std::array<double, 3>{0, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) wall.point[i] = 0.03 * wall.normal[i];
  if (shape == Shape::Flat) return flat_wall(wall);
  Teuchos::ParameterList valid, user;
  obstacles().declare(valid);
  Teuchos::Array<double> place(dimension, 0.0);
  if (shape == Shape::Waves) {
    user.set("Obstacle", "Sine Wall");
    place.back() = 0.03;
    user.sublist("Sine Wall").set("Point", place).set("Amplitude", 0.04).set("Period", 1.3).set("Gap", "Vertical");
  } else {
    user.set("Obstacle", "Sphere");
    place.back() = shape == Shape::Cavity ? 30.03 : -29.97;
    user.sublist("Sphere").set("Radius", 30.0).set("Center", place).set("Cavity", shape == Shape::Cavity);
  }
  const Teuchos::ParameterList list = validated(user, valid);
  return obstacles().make(SceneNode(list, ""), static_cast<std::size_t>(dimension));
}

inline Friction friction(FrictionType type, bool current) {
  Friction result;
  result.type = type;
  result.stress = 0.03;
  result.sharpness = 20;
  result.coefficient = 0.8;
  result.slip_speed = 0.02;
  result.stiffness = 5;
  result.current = current;
  return result;
}

inline const Friction all_frictions[] = {
    friction(FrictionType::ConstantStress, false),   friction(FrictionType::ConstantStress, true),
    friction(FrictionType::ExtendedAmontons, false), friction(FrictionType::ExtendedAmontons, true),
    friction(FrictionType::Smoothed, false),         friction(FrictionType::Smoothed, true)};

inline const std::pair<int, ContactElement> bodies[] = {{2, ContactElement::Q1C1}, {2, ContactElement::Q1CH},
                                                        {3, ContactElement::Q1C1}, {3, ContactElement::Q1C2},
                                                        {3, ContactElement::Q2C2}, {3, ContactElement::Q2C4}};

/// The terms of a surface and a sequence of displacements that slides them, by a tenth of L0 a step if `size` is 1.
class Sliding {
 public:
  Sliding(int dimension, ContactElement element, const Friction& friction, Shape shape,
          const SurfaceOptions& options = {})
      : model(box_with_contact(dimension, element)) {
    const LocalMesh& mesh = model->mesh();
    const FrictionLaw law(friction, gap_law(VanDerWaals(2.5, 25)));
    terms = make_friction_terms(mesh, mesh.side_sets[mesh.side_set("bottom")], model->pattern(), law,
                                obstacle(shape, dimension), options);
    begin_anew();
  }
  /// Begins the lives of the terms.
  void begin_anew() {
    steps.clear();
    for (auto& term : terms) steps.push_back(std::make_unique<ByHand<Interaction>>(*term));
    for (auto& own : steps) own->initialize(at_rest(*model).data());
  }

  /// Returns the displacement after n steps: the body goes round and breathes a little.
  std::vector<double> at(double n, double size = 1) const {
    std::vector<double> u = smooth_field(*model, 0.003 * std::sin(2.3 * n));
    const LocalMesh& mesh = model->mesh();
    const auto d = static_cast<std::size_t>(mesh.dimension);
    for (std::size_t k = 0; k < u.size(); ++k) {
      if (mesh.is_derivative(k / d)) continue;
      if (k % d == 0) u[k] += 0.1 * size * std::sin(n);
      if (k % d + 1 == d) u[k] += 0.02 * std::cos(1.7 * n);
      if (d == 3 && k % d == 1) u[k] += 0.1 * size * (1 - std::cos(n));
    }
    return u;
  }

  /// Takes three steps that slide and begins a fourth. Returns the displacement there.
  std::vector<double> slide() {
    std::vector<double> from = at(0);
    for (int n = 1; n <= 3; ++n) {
      begin(from);
      const std::vector<double> to = at(n);
      accept(from, to);
      from = to;
    }
    begin(from);
    return from;
  }
  void begin(const std::vector<double>& u) {
    for (auto& own : steps) own->begin_step(u.data(), 0, 0.5);
  }
  /// Returns what the step dissipated, on all ranks.
  double accept(const std::vector<double>& from, const std::vector<double>& to) {
    double lost = 0;
    for (auto& own : steps) lost += own->accept({{{from.data()}, {to.data()}}, nullptr, 0.5}).dissipated;
    model->space().sum(&lost, 1);
    return lost;
  }
  std::vector<double> force(const Segment& segment, const Rule& rule) const {
    std::vector<double> f(static_cast<std::size_t>(model->space().local()), 0.0);
    for (std::size_t i = 0; i < terms.size(); ++i)
      EXPECT_TRUE(terms[i]->add_force(steps[i]->in(segment), rule, f.data()));
    return f;
  }
  std::vector<double> tangent(const Segment& segment, const Rule& rule, Tangent kind = Tangent::Exact) const {
    std::vector<double> values = no_values(*model);
    for (std::size_t i = 0; i < terms.size(); ++i)
      terms[i]->add_tangent(steps[i]->in(segment), rule, kind, values.data());
    return values;
  }
  std::vector<double> product(const Segment& segment, const Rule& rule, const std::vector<double>& x,
                              Tangent kind = Tangent::Exact) const {
    return matrix_product(*model, tangent(segment, rule, kind).data(), x);
  }
  double energy(const std::vector<double>& u) const {
    double sum = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) sum += terms[i]->energy(steps[i]->at(u.data()));
    model->space().sum(&sum, 1);
    return sum;
  }
  /// Calls visit(term, its steps) for all terms.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t i = 0; i < terms.size(); ++i) visit(*terms[i], *steps[i]);
  }
  double dot(const std::vector<double>& f, const std::vector<double>& a, const std::vector<double>& b) const {
    double sum = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(model->space().owned()); ++k) sum += f[k] * (a[k] - b[k]);
    model->space().sum(&sum, 1);
    return sum;
  }

  std::unique_ptr<Model> model;
  Interactions terms;
  std::vector<std::unique_ptr<ByHand<Interaction>>> steps;  ///< of the terms
};

/// Calls visit(sliding, friction) for each body with each law; the obstacle's shape is another one each time, so that
/// each body and each law meets every shape. All triples of the three would be four times as many.
template <class Visit>
void for_each_case(const Visit& visit) {
  std::size_t turn = 0;
  for (const auto& [dimension, element] : bodies) {
    std::size_t next = turn++;
    for (const Friction& friction : all_frictions) {
      const auto& [shape, name] = shapes[next++ % std::size(shapes)];
      SCOPED_TRACE(testing::Message() << dimension << "D, friction " << static_cast<int>(friction.type)
                                      << (friction.current ? ", current" : ", lagged") << ", " << name);
      Sliding sliding(dimension, element, friction, shape);
      visit(sliding, friction);
    }
  }
}

}  // namespace ixos::test
