// Studies: a study file beside a small scene.
#include "base/error.hpp"
#include "input.hpp"
#include "study/compare/study.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  static const std::string folder = [] {
    fuzz::write_file(fuzz::scratch_folder() + "/small.xml", fuzz::small_scene());
    return fuzz::scratch_folder();
  }();
  fuzz::write_file(folder + "/study.xml", fuzz::text(data, size));
  try {
    const Study study = read_study(folder + "/study.xml");
    fuzz::expect(!study.runs.empty(), "a study without runs");
    for (const StudyRun& run : study.runs)
      fuzz::expect(run.name.find('/') == std::string::npos && run.name != "." && run.name != "..",
                   "a run would leave the study's folder");
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}
