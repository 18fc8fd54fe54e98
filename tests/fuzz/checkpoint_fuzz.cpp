// Checkpoints: the file as it is, then sealed anew, as whoever means harm would, so that HDF5 and the readers see it.
#include "base/error.hpp"
#include "checkpoint/seal.hpp"
#include "input.hpp"
#include "run/restart.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  static const std::string path = fuzz::scratch_folder() + "/checkpoint.h5";
  fuzz::write_file(path, fuzz::text(data, size));
  seal_problem(path);
  if (size < seal_bytes) return 0;
  seal(path, {{seal_bytes, size - seal_bytes, checksum(data + seal_bytes, size - seal_bytes)}});
  fuzz::expect(seal_problem(path).empty(), "a sealed file is not sound");
  Simulation& simulation = fuzz::simulation("Central Difference");
  try {
    Restart restart(simulation, path);
    restart.load([&](Record& record) {
      const Record::Section run(record, "run");
      simulation.integrator().transfer(record);
    });
    simulation.integrator().attempt(0.1);
  } catch (const InputError& error) {
    fuzz::expect_message(error);
    // Ranks agree on the standard library's exceptions as on refusals.
    const std::string message = error.what();
    for (const char* word : {"std::", "vector::", "basic_string::"})
      fuzz::expect(message.rfind(word, 0) != 0, "a refusal in C++");
  }
  return 0;
}
