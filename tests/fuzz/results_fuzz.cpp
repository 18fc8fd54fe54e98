// Results that a study compares: history.csv, effective.xml and summary.json, separated by lines of ----.
#include "base/error.hpp"
#include "input.hpp"
#include "study/compare/study_errors.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  static const std::string folder = fuzz::scratch_folder();
  const std::vector<std::string> files = fuzz::pieces(fuzz::text(data, size), "----\n", 3);
  fuzz::write_file(folder + "/history.csv", files[0]);
  fuzz::write_file(folder + "/effective.xml", files[1]);
  fuzz::write_file(folder + "/summary.json", files[2]);
  try {
    StudyReference reference(folder, {});
    reference.errors(folder);
    reference.judge(folder, "the same run");
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  } catch (const FileError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}
