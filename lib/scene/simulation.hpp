/// A scene made ready to run.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <string>

#include "base/tpetra.hpp"
#include "time/integrator.hpp"

namespace ixos {

/// Everything that a scene asks for, built and at its initial state. Collective.
class Simulation {
 public:
  /// `scene` as a user writes it: it is validated here. Throws InputError with the list path.
  /// `folder` is where the scene's file stands, for mesh files named relative to it.
  Simulation(const Teuchos::ParameterList& scene, const Comm& comm, const std::string& folder = ".");

  const Teuchos::ParameterList& parameters() const { return parameters_; }  ///< complete, every default filled in
  const Model& model() const { return *model_; }
  Integrator& integrator() { return *integrator_; }
  double final_time() const;
  double time_step() const;
  double setup_seconds() const { return setup_seconds_; }

 private:
  void build_model(const Comm& comm, const std::string& folder);
  void build_integrator();
  void set_initial_state();

  Teuchos::ParameterList parameters_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Integrator> integrator_;
  double setup_seconds_ = 0;
};

}  // namespace ixos
