#include "io/drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/digest.hpp"
#include "base/error.hpp"
#include "io/child_process.hpp"
#include "io/disk_file.hpp"
#include "io/geo_script.hpp"
#include "io/msh_file.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

using Path = std::filesystem::path;

/// A variable of the environment: programs that this one starts inherit it.
const char* const trust = "IXOS_TRUST_GEOMETRY";
bool trusts_geometry() {
  const char* const value = std::getenv(trust);
  return value != nullptr && std::string(value) == "1";
}

const char* const constants = "Constants";
const char* const local = "Size At";

/// Changes where another script is written for the same settings.
constexpr int script_version = 2;
/// Number of the first field in the scripts, beyond those of drawings, and how fast cells grow beyond a box.
constexpr int first_field = 100001;
constexpr double growth = 0.5;

const Options<DrawingOptions>& options() {
  static const Options<DrawingOptions> all =
      Options<DrawingOptions>()
          .add("Size", &DrawingOptions::size,
               "Size of the largest cells [L0]. With 0 it is the drawing's own, or gmsh's: a tenth of the body.",
               at_least(0))
          .add("Size Factor", &DrawingOptions::factor,
               "Factor of all sizes [-]: of Size, of Size At and of those in the drawing. Half of it halves all cells.",
               greater_than(0))
          .add("Order", &DrawingOptions::order,
               "2 makes quadratic cells whose sides follow the curves of the drawing; Cell Order 2 would make straight "
               "ones.",
               between(1, 2))
          .free_form(constants, &DrawingOptions::constants,
                     "Numbers and texts for the names that a .geo file gives a value by DefineConstant, in its own "
                     "units.");
  return all;
}

const Options<LocalSize>& local_options() {
  static const Options<LocalSize> all =
      Options<LocalSize>()
          .require("Size", &LocalSize::size, "Size of the cells there [L0].", greater_than(0))
          .add("Group", &LocalSize::group,
               "Name of a physical group of points, curves, surfaces or volumes. If empty, it is the list's name.")
          .add("Lower", &LocalSize::lower,
               "A box in place of a group, for drawings without names: its smallest coordinates [L0], two or three of "
               "them. Cells in it have the size; beyond it they grow by half of the distance.",
               any_number())
          .add("Upper", &LocalSize::upper, "The box's largest coordinates [L0], as many.", any_number());
  return all;
}

/// Returns the path of a program, as a shell finds it; "" if there is none.
std::string program(const std::string& name) {
  const char* const all = std::getenv("PATH");
  std::string folders = all == nullptr ? "" : all;
  for (std::size_t begin = 0; begin < folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    std::string path = folders.substr(begin, end - begin) + "/" + name;
    if (access(path.c_str(), X_OK) == 0 && is_file(path)) return path;
    begin = end + 1;
  }
  return "";
}

/// Returns the folder of meshes, which exists then.
std::string cache_folder() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  Path base = variable("XDG_CACHE_HOME");
  if (base.empty() && !variable("HOME").empty()) base = Path(variable("HOME")) / ".cache";
  if (base.empty()) base = std::filesystem::temp_directory_path() / fmt::format("cache-{}", getuid());
  const Path folder = base / "ixos" / "meshes";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
  return folder.string();
}

/// A drawing on its way to a mesh.
class Meshing {
 public:
  Meshing(const std::string& path, const DrawingOptions& own)
      : path_(std::filesystem::absolute(path).string()), options_(own), gmsh_(program("gmsh")) {
    files_ = drawing_files(path_, trusts_geometry());
    if (path_.find_first_of("\"\n") != std::string::npos) refuse("its path has a quote or a new line");
    if (gmsh_.empty())
      refuse("it takes the program gmsh, which is not on the PATH; install gmsh, or give a mesh that it saved (.msh)");
  }

  DrawnMesh result() {
    const std::string stem = cache_folder() + "/" + key(), mesh = stem + ".msh", log = stem + ".log";
    if (is_file(mesh)) return {mesh, lines(log, "Warning")};
    const Workshop workshop(stem);
    folder_ = workshop.folder();
    const std::string unfinished = mesh_of(script(), fmt::format("-{}", options_.dimension == 2 ? 2 : 3));
    sync_to_disk(unfinished);
    replace_file(log_of_gmsh(), log);  // before the mesh: who finds that reads the log
    replace_file(unfinished, mesh);
    return {mesh, lines(log, "Warning")};
  }

 private:
  /// A folder for one call of this process, which is removed with all that is left in it.
  class Workshop {
   public:
    explicit Workshop(const std::string& stem) : folder_(stem + "-XXXXXX") {
      if (mkdtemp(folder_.data()) == nullptr) throw FileError(folder_ + ": cannot be made");
    }
    ~Workshop() {
      std::error_code error;
      std::filesystem::remove_all(folder_, error);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    const std::string& folder() const { return folder_; }

   private:
    std::string folder_;
  };

  [[noreturn]] void refuse(const std::string& what) const { throw InputError(fmt::format("{}: {}", path_, what)); }

  /// Returns the checksum of all that the mesh depends on.
  std::string key() const {
    Digest digest;
    const auto add = [&](const std::string& text) { digest.add_array(text); };
    digest.add_number(script_version);
    struct stat state {};
    stat(gmsh_.c_str(), &state);
    digest.add_number(state.st_mtime);
    digest.add_number(state.st_size);
    for (const std::string& file : files_) add(read_whole_file(file));
    for (const std::string& word : words()) add(word);
    digest.add_number(options_.dimension);
    for (const LocalSize& own : options_.local) {
      add(own.name + '\n' + own.group);
      digest.add_array(own.lower);
      digest.add_array(own.upper);
      add(fmt::format("{}", own.size));
    }
    add(fmt::format("{} {} {} {}", options_.size, options_.length_unit, options_.order, options_.factor));
    const Checksum sum = digest.value();
    return fmt::format("{:016x}{:016x}", sum[0], sum[1]);
  }

  /// Returns the command line's settings.
  std::vector<std::string> words() const {
    std::vector<std::string> all{"-nopopup", "-v", "3"};
    for (const auto& [name, entry] : entries(options_.constants)) {
      const bool is_text = entry.isType<std::string>();
      const auto is_part = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
      if (!std::all_of(name.begin(), name.end(), is_part) || !has_word(files_, name))
        refuse(fmt::format("Drawing/{}/{}: no script of the drawing has such a name", constants, name));
      std::string value;
      if (is_text)
        value = Teuchos::getValue<std::string>(entry);
      else if (entry.isType<int>())
        value = std::to_string(Teuchos::getValue<int>(entry));
      else if (entry.isType<double>())
        value = fmt::format("{}", Teuchos::getValue<double>(entry));
      else
        refuse(fmt::format("the constant \"{}\" has to be a double, an int or a string", name));
      for (const std::string& word : {std::string(is_text ? "-setstring" : "-setnumber"), name, value})
        all.push_back(word);
    }
    return all;
  }

  /// Returns a script that reads the drawing and sets sizes, in the drawing's unit.
  std::string script() {
    std::string text = fmt::format(
        "Merge \"{}\";\nMesh.ElementOrder = {};\nMesh.SecondOrderIncomplete = 0;\nMesh.MeshSizeFactor = {};\n", path_,
        options_.order, options_.factor);
    if (options_.size > 0) text += fmt::format("Mesh.MeshSizeMax = {};\n", options_.size / options_.length_unit);
    std::vector<int> fields;
    for (const LocalSize& own : options_.local) {
      if (own.lower.empty() && own.upper.empty()) {
        text += fmt::format("MeshSize {{{}}} = {};\n", of_group(own), own.size / options_.length_unit);
      } else {
        fields.push_back(first_field + static_cast<int>(fields.size()));
        text += in_box(own, fields.back());
      }
    }
    if (!fields.empty())
      text += fmt::format("Field[{0}] = Min;\nField[{0}].FieldsList = {{{1}}};\nBackground Field = {0};\n",
                          fields.back() + 1, fmt::join(fields, ", "));
    return text;
  }

  /// Returns the points of a group, of the groups of that name in all dimensions.
  std::string of_group(const LocalSize& own) {
    if (!probed_) probe();
    const std::string& group = own.group.empty() ? own.name : own.group;
    static constexpr std::array<const char*, 4> kinds{"Point", "Curve", "Surface", "Volume"};
    std::vector<std::string> points, known;
    for (const auto& [tag, name] : probe_.names) {
      known.push_back("\"" + name + "\"");
      if (name != group) continue;
      for (const auto& [entity, groups] : probe_.groups)
        if (entity.first == tag.first && std::find(groups.begin(), groups.end(), tag.second) != groups.end())
          points.push_back(tag.first == 0 ? std::to_string(entity.second)
                                          : fmt::format("PointsOf{{ {}{{{}}}; }}",
                                                        kinds[static_cast<std::size_t>(tag.first)], entity.second));
    }
    if (points.empty())
      refuse(fmt::format("Drawing/{}/{}: there is no physical group \"{}\"; {}", local, own.name, group,
                         known.empty() ? std::string("the drawing has none: give Lower and Upper of a box")
                                       : fmt::format("there are {}", fmt::join(known, ", "))));
    return fmt::format("{}", fmt::join(points, ", "));
  }

  /// Returns the definition of a field of gmsh that has the size in the box.
  std::string in_box(const LocalSize& own, int field) const {
    if (has_word(files_, "Background"))
      refuse(
          fmt::format("Drawing/{}/{}: a box cannot be added to the Background Field that the drawing sets; name a "
                      "physical group",
                      local, own.name));
    if (own.lower.size() != own.upper.size() || own.lower.size() < 2 || own.lower.size() > 3)
      refuse(fmt::format("Drawing/{}/{}: Lower and Upper have {} and {} numbers; two or three of both are needed",
                         local, own.name, own.lower.size(), own.upper.size()));
    std::string text = fmt::format("Field[{}] = Box;\n", field);
    const auto set = [&](const std::string& name, double value) {
      text += fmt::format("Field[{}].{} = {};\n", field, name, value);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const bool given = i < own.lower.size();
      if (given && own.lower[i] > own.upper[i])
        refuse(fmt::format("Drawing/{}/{}: Lower {} is above Upper {} in direction {}", local, own.name, own.lower[i],
                           own.upper[i], "xyz"[i]));
      set(fmt::format("{}Min", "XYZ"[i]), given ? own.lower[i] / options_.length_unit : -1e22);
      set(fmt::format("{}Max", "XYZ"[i]), given ? own.upper[i] / options_.length_unit : 1e22);
    }
    const double size = own.size / options_.length_unit, beyond = options_.size / options_.length_unit;
    set("VIn", size);
    set("VOut", beyond > 0 ? std::max(beyond, size) : 1e22);
    if (beyond > size) set("Thickness", (beyond - size) / growth);
    return text;
  }

  /// Finds the physical groups: those of a mesh of the curves alone.
  void probe() {
    probe_ = read_msh_file(MshSource(mesh_of(fmt::format("Merge \"{}\";\n", path_), "-1")));
    probed_ = true;
  }

  std::string log_of_gmsh() const { return folder_ + "/gmsh.log"; }

  /// Lets gmsh mesh a script; returns the path of the mesh.
  std::string mesh_of(const std::string& text, const std::string& extent) const {
    const std::string path = folder_ + "/script.geo";
    std::string mesh = folder_ + "/mesh.msh";
    write_whole_file(path, text);
    std::vector<std::string> command = words();
    command.insert(command.begin(), gmsh_);
    for (const std::string& word :
         {path, extent, std::string("-format"), std::string("msh41"), std::string("-o"), mesh})
      command.push_back(word);
    const int status = ChildProcess(command, log_of_gmsh()).wait().exit_status;
    const std::vector<std::string> errors = lines(log_of_gmsh(), "Error");
    if (status == 0 && errors.empty() && is_file(mesh)) return mesh;
    if (!errors.empty()) refuse(fmt::format("gmsh says: {}", fmt::join(errors, "; ")));
    refuse(fmt::format("gmsh made no mesh: exit status {}, {}", status, last_line(log_of_gmsh())));
  }

  /// Returns what gmsh said in lines of a kind, five of them at most.
  static std::vector<std::string> lines(const std::string& log_file, const std::string& kind) {
    std::vector<std::string> found;
    std::ifstream log = open_text(log_file);
    for (std::string line; std::getline(log, line);) {
      if (line.rfind(kind, 0) != 0) continue;
      const std::size_t colon = line.find(": ");
      if (colon == std::string::npos) continue;
      std::string text = line.substr(colon + 2);
      if (std::find(found.begin(), found.end(), text) == found.end()) found.push_back(std::move(text));
      if (found.size() == 5) break;
    }
    return found;
  }

  std::string path_;
  const DrawingOptions& options_;
  std::string gmsh_;
  std::vector<std::string> files_;  ///< the drawing's
  std::string folder_;              ///< for gmsh's files
  bool probed_ = false;
  MshFile probe_;  ///< only its groups
};

}  // namespace

bool is_drawing(const std::string& path) {
  // As gmsh spells them: it would read a .Step as a script.
  static constexpr std::array<const char*, 11> endings{".geo",  ".step", ".STEP", ".stp", ".STP", ".brep",
                                                       ".BREP", ".iges", ".IGES", ".igs", ".IGS"};
  return std::find(endings.begin(), endings.end(), Path(path).extension().string()) != endings.end();
}

void declare_drawing(Teuchos::ParameterList& list) {
  options().declare(list);
  local_options().declare(
      list.sublist(local, false, "Sizes of cells at parts of the drawing. The scene chooses the names of these lists.")
          .sublist(any_name));
}

DrawingOptions read_drawing(const SceneNode& node) {
  DrawingOptions result = options().read(node);
  for (const SceneNode& own : node.sublist(local).sublists()) {
    result.local.push_back(local_options().read(own));
    result.local.back().name = own.name();
  }
  return result;
}

DrawnMesh drawn_mesh(const std::string& path, const DrawingOptions& options) { return Meshing(path, options).result(); }

void trust_geometry() { setenv(trust, "1", 1); }

}  // namespace ixos
