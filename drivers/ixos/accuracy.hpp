/// ixos --accuracy: runs with ever finer steps, until the quantities that the scene names are accurate enough.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

#include "ixos/arguments.hpp"
#include "study/accuracy/accuracy.hpp"

namespace ixos {

/// A scene, as a user writes it, and the folder of its file.
struct PlacedScene {
  Teuchos::ParameterList list;
  std::string folder;
};

/// The question of --accuracy about a scene, and the settings of the first run.
struct AccuracyTask {
  AccuracyQuestion question;
  AccuracySettings first;
};

/// Throws InputError if the scene names no quantity, or its scheme cannot adapt steps. Collective.
AccuracyTask accuracy_task(const PlacedScene& scene, double accuracy, const Comm& comm);

/// Returns the scene of a run with these settings.
PlacedScene with_settings(PlacedScene scene, const AccuracySettings& settings);

/// Carries the runs out, each in place of the one before, and tells what they achieve. Returns the exit status.
/// Collective.
int reach_accuracy(const PlacedScene& scene, const AccuracyTask& task, const Arguments& arguments, const Comm& comm);

}  // namespace ixos
