// Newton iterations and slow steps of two bodies take no new memory.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "support/comparison.hpp"
#include "support/pair_of_bodies.hpp"
#include "term/force_term.hpp"
#include "term/friction_fixture.hpp"

namespace {

std::atomic<long> allocations{0};

void* allocate(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* const memory = alignment <= alignof(std::max_align_t)
                           ? std::malloc(size)
                           : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Those of the whole test program.
void* operator new(std::size_t size) { return allocate(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace ixos {
namespace {

/// Returns how often a Newton iteration takes memory after three others, in which closest points move and nodes are as
/// near.
long taken(const test::PairOfBodies& bodies, const Rule& rule) {
  const std::vector<double> from = test::at_rest(*bodies.model), way = test::smooth_field(*bodies.model, 0.02);
  std::vector<double> to = from, f(static_cast<std::size_t>(bodies.model->space().local()), 0.0),
                      values = test::no_values(*bodies.model);
  long before = 0;
  for (int iteration = 0; iteration < 4; ++iteration) {
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += 0.02 * way[k];
    const Segment segment{from.data(), nullptr, to.data()};
    before = allocations;
    bodies.term->add_force(bodies.steps->in(segment), rule, f.data());
    bodies.term->add_tangent(bodies.steps->in(segment), rule, Tangent::Exact, values.data());
    bodies.term->admissibility().admissible_step(segment, rule, way.data());
    bodies.term->energy(bodies.steps->at(to.data()));
    bodies.term->admissibility().gap_ratio({from.data(), nullptr, to.data()});
  }
  return allocations - before;
}

TEST(PairMemoryTest, ANewtonIterationTakesNone) {
  const long at_first = allocations;
  for (const double cutoff : {0.0, 1.5}) {
    std::vector<test::PairOfBodies> all;
    all.emplace_back(test::two_disks(3, {5, 3.6}, 8, 2), "a_surface", "b_surface", Smoothing::CatmullRom, cutoff);
    all.emplace_back(test::two_disks(3, {5, 3.6}, 8, 2), "a_surface", "b_surface", Smoothing::Spline, cutoff);
    all.emplace_back(test::two_blocks(0.3), "upper_bottom", "lower_top", Smoothing::None, cutoff);
    all.emplace_back(test::two_balls(2, {2.4, 2, 2.9}), "a_surface", "b_surface", Smoothing::CatmullRom, cutoff);
    all.emplace_back(test::two_balls(2, {2.4, 2, 2.9}), "a_surface", "b_surface", Smoothing::Spline, cutoff);
    for (const test::PairOfBodies& bodies : all) {
      EXPECT_EQ(taken(bodies, end_rule()), 0);
      EXPECT_EQ(taken(bodies, point_rule({0.1, 0.4, 0.9}, {0.3, 0.4, 0.3})), 0);
      EXPECT_EQ(taken(bodies, discrete_gradient_rule()), 0);
    }
  }
  EXPECT_GT(allocations, at_first) << "they are not counted";
}

/// Returns how often a step takes memory after three others, in which the bodies move too little for a new search.
long taken_by_a_step(Model& model) {
  test::ByHand<const Model> steps(model);
  const std::vector<double> way = test::smooth_field(model, 1e-5);
  // No closest point is on an edge, which the least motion could make it leave.
  std::vector<double> from = test::smooth_field(model, 0.02), to = from, f(from.size(), 0.0),
                      values = test::no_values(model);
  const Rule rule = end_rule();
  steps.initialize(from.data());
  long before = 0;
  for (int step = 0; step < 4; ++step) {
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += way[k];
    AcceptedStep accepted{{{from.data()}, {to.data()}}, nullptr, 1, &steps.memories};
    const StepStart start{{from.data()}, 1, &steps.histories};
    steps.in_step = true;
    const Segment segment = steps.segment(from.data(), nullptr, to.data());
    before = allocations;
    for (const NamedInteraction& named : model.interactions()) {
      Interaction& term = *named.term;
      term.begin_step(start, steps.memories);
      if (term.coupling() != nullptr) term.coupling()->update_stencils(from.data());
      term.add_force(segment, rule, f.data());
      term.add_tangent(segment, rule, Tangent::Exact, values.data());
      if (!term.has_friction() && !term.admissibility().is_clear(segment.end()))
        term.admissibility().lowest_point(segment.end());
      term.energy(segment.end());
      term.accept(accepted, steps.histories);
    }
    if (step < 3) from = to;
  }
  return allocations - before;
}

/// The surfaces are closed; below a free rim each step looks for the lowest point.
TEST(PairMemoryTest, AStepWithoutASearchTakesNone) {
  for (const double cutoff : {0.0, 1.5})
    for (const bool rubs : {false, true}) {
      const Friction friction = rubs ? test::friction(FrictionType::ConstantStress, false) : Friction();
      const auto taken_by = [&](const Mesh& mesh, Smoothing smoothing) {
        const test::PairOfBodies bodies(mesh, "a_surface", "b_surface", smoothing, cutoff,
                                        gap_law(VanDerWaals(2.5, 25)), Passes::One, 0, friction);
        return taken_by_a_step(*bodies.model);
      };
      EXPECT_EQ(taken_by(test::two_disks(3, {5, 3.6}, 8, 2), Smoothing::CatmullRom), 0);
      for (const Smoothing smoothing : {Smoothing::CatmullRom, Smoothing::Spline})
        EXPECT_EQ(taken_by(test::two_balls(2, {2.4, 2, 2.9}), smoothing), 0);
    }
}

}  // namespace
}  // namespace ixos
