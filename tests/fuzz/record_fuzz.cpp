// What a sound checkpoint may say: values of every kind, taken from the input in turn, for all that a run restores.
#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "base/record.hpp"
#include "histories/waveform.hpp"
#include "input.hpp"
#include "run/history.hpp"
#include "run/run_files.hpp"
#include "scene/read/stop.hpp"
#include "time/step_control.hpp"

namespace {

using namespace ixos;

/// Gives what CheckpointReader may give of a hostile file.
class HostileRecord final : public Record {
 public:
  HostileRecord(const std::uint8_t* data, std::size_t size, const DofSpace& space)
      : data_(data), end_(data + size), space_(space), kind_(byte()) {}

  bool loading() const override { return true; }
  bool same_scene() const override { return (kind_ & 1) == 0; }
  bool same_solution() const override { return (kind_ & 2) == 0; }
  bool same_partition() const override { return (kind_ & 4) == 0; }
  void text(const char*, std::string& value) override { value.assign(byte() % 8, 'x'); }
  /// Empty or whole, and finite.
  void field(const char*, std::vector<double>& values, Extent extent) override {
    values.assign(static_cast<std::size_t>(extent == Extent::Local ? space_.local() : space_.owned()), 0.0);
    if (byte() % 8 == 1) values.clear();
    for (double& value : values)
      if (const double next = number_in(); std::isfinite(next)) value = next;
  }
  void share(const char*, std::vector<double>& values) override {
    values.resize(byte() % 8 == 1 ? byte() : values.size());
    for (double& value : values) value = number_in();
  }

  void all_shares(const char*, std::vector<double>& values) override {
    values.resize(byte());
    for (double& value : values)
      if (const double next = number_in(); std::isfinite(next)) value = next;
  }

 private:
  void scalar(const char*, double& value) override {
    if (byte() % 4 != 0) value = number_in();
    if (exhausted()) throw InputError("the file ends");
  }
  void enter(const std::string&) override {
    if (exhausted()) throw InputError("the file ends");
  }
  void leave() override {}
  bool exhausted() const { return data_ == end_; }
  std::uint8_t byte() { return exhausted() ? std::uint8_t{0} : *data_++; }
  /// Of eight bytes, or small and whole.
  double number_in() {
    const std::uint8_t first = byte();
    if (first < 128) return first / 4.0;
    if (end_ - data_ < 8) return first;
    double value = 0;
    std::memcpy(&value, data_, sizeof(value));
    data_ += sizeof(value);
    return value;
  }

  const std::uint8_t *data_, *end_;
  const DofSpace& space_;
  std::uint8_t kind_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  Simulation& simulation = fuzz::simulation(data[0] % 2 == 0 ? "Central Difference" : "Average Vector Field");
  Integrator& integrator = simulation.integrator();
  StopCriteria stop = simulation.stop_criteria();
  StepControl control(simulation.step_control());
  RunFiles files(simulation, fuzz::scratch_folder());
  HostileRecord record(data + 1, size - 1, simulation.model().space());
  try {
    files.transfer(record, 0, 0);
    files.history().transfer(record);
    stop.transfer(record);
    control.transfer(record);
    integrator.transfer(record);
    Waveform().transfer(record);
    if (control.done(integrator.time())) return 0;
    const double dt = control.next(integrator.time());
    if (dt > 0) integrator.attempt(dt);
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}
