#include "input.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <Tpetra_Core.hpp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "scene/scene_file.hpp"

// Of LeakSanitizer, where that is linked.
extern "C" __attribute__((weak)) void __lsan_disable();  // NOLINT: its name
extern "C" __attribute__((weak)) void __lsan_enable();   // NOLINT

namespace ixos::fuzz {

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "finding: %s\n", what);
  std::abort();
}

void expect_message(const std::exception& error) { expect(std::strlen(error.what()) > 5, "a refusal without words"); }

std::string text(const std::uint8_t* data, std::size_t size) {
  return size == 0 ? std::string() : std::string(reinterpret_cast<const char*>(data), size);
}

std::vector<std::string> pieces(const std::string& text, const std::string& separator, std::size_t count) {
  std::vector<std::string> result;
  std::size_t start = 0;
  while (result.size() + 1 < count) {
    const std::size_t end = text.find(separator, start);
    if (end == std::string::npos) break;
    result.push_back(text.substr(start, end - start));
    start = end + separator.size();
  }
  result.push_back(text.substr(start));
  result.resize(count);
  return result;
}

MemoryFile::MemoryFile(const void* data, std::size_t size) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
  const auto* bytes = static_cast<const char*>(data);
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = write(descriptor_, bytes + done, size - done);
    expect(count > 0, "no memory for a file");
    done += static_cast<std::size_t>(count);
  }
}

MemoryFile::~MemoryFile() { close(descriptor_); }

std::string MemoryFile::path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

const std::string& scratch_folder() {
  struct Folder {
    Folder() {
      path = (std::filesystem::temp_directory_path() / "ixos-fuzz-XXXXXX").string();
      expect(mkdtemp(path.data()) != nullptr, "no scratch folder");
    }
    ~Folder() {
      std::error_code code;
      std::filesystem::remove_all(path, code);
    }
    std::string path;
  };
  static const Folder folder;
  return folder.path;
}

void write_file(const std::string& path, const std::string& contents) {
  std::ofstream(path, std::ios::binary) << contents;
}

std::string small_scene(const std::string& scheme, const std::string& fields) {
  return R"x(<ParameterList name="Small">
<ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/></ParameterList>
<ParameterList name="Materials"><ParameterList name="Rubber"/></ParameterList>
<ParameterList name="Interactions"><ParameterList name="Wall">
<Parameter name="Side Set" type="string" value="bottom"/>
<Parameter name="Point" type="Array(double)" value="{0, -0.5}"/></ParameterList></ParameterList>
<ParameterList name="Boundary Conditions"><ParameterList name="Held">
<Parameter name="Node Set" type="string" value="top"/></ParameterList></ParameterList>
<ParameterList name="Time Integrator"><Parameter name="Type" type="string" value=")x" +
         scheme + R"x("/>
<ParameterList name="Time Step Control"><Parameter name="Final Time" type="double" value="1"/>
<Parameter name="Time Step" type="double" value="0.5"/></ParameterList></ParameterList>
<ParameterList name="Output"><Parameter name="Fields Format" type="string" value=")x" +
         fields + R"x("/><Parameter name="Reactions" type="Array(string)" value="{top}"/>
<ParameterList name="Probes"><ParameterList name="P"><Parameter name="Point" type="Array(double)" value="{0, 0}"/>
</ParameterList></ParameterList></ParameterList></ParameterList>
)x";
}

Comm comm() {
  static const Comm world = [] {
    int count = 1;
    char name[] = "fuzz";
    char* words[] = {name, nullptr};
    char** arguments = words;
    if (__lsan_disable != nullptr) __lsan_disable();  // MPI keeps what it allocates
    Tpetra::initialize(&count, &arguments);
    if (__lsan_enable != nullptr) __lsan_enable();
    return Tpetra::getDefaultComm();
  }();
  return world;
}

Simulation& simulation(const std::string& scheme, const std::string& fields) {
  static std::map<std::string, std::unique_ptr<Simulation>> made;
  static int calls = 0;
  if (++calls % 200 == 0) made.clear();
  std::unique_ptr<Simulation>& simulation = made[scheme + fields];
  if (!simulation)
    simulation = std::make_unique<Simulation>(read_scene_text(small_scene(scheme, fields), "the small scene"), comm());
  const std::vector<double> rest(static_cast<std::size_t>(simulation->model().space().local()), 0.0);
  simulation->integrator().initialize(rest, rest, 0);
  return *simulation;
}

}  // namespace ixos::fuzz
