#include "io/field_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/exodus_definition.hpp"
#include "io/guarded.hpp"
#include "io/output_mesh.hpp"

namespace ixos {
namespace {

int create(const std::string& path) {
  const int id = create_exodus(path);
  require_created(id, path);
  return id;
}

int open(const std::string& path, int mode) {
  int word = 8, stored = 0;
  float version = 0;
  const int id = std::filesystem::is_regular_file(path) ? ex_open(path.c_str(), mode, &word, &stored, &version) : -1;
  if (id < 0)
    throw InputError(path + ": the frames to go on with are not there, or damaged; another --output begins new ones");
  return id;
}

std::string file_name(const std::string& path, int rank, int ranks) {
  if (ranks == 1) return path;
  return fmt::format("{}.{}.{:0{}}", path, ranks, rank, fmt::format("{}", ranks - 1).size());
}

void define_variables(const ExodusHandle& file, ex_entity_type type, const std::vector<std::string>& names) {
  if (names.empty()) return;
  std::vector<char*> words;
  words.reserve(names.size());
  for (const std::string& name : names) words.push_back(const_cast<char*>(name.c_str()));
  require_written(ex_put_variable_param(file, type, static_cast<int>(names.size())), file, "variables");
  require_written(ex_put_variable_names(file, type, static_cast<int>(names.size()), words.data()), file, "variables");
}

bool has_variables(const ExodusHandle& file, ex_entity_type type, const std::vector<std::string>& names) {
  int count = 0;
  if (ex_get_variable_param(file, type, &count) < 0 || count != static_cast<int>(names.size())) return false;
  for (int i = 0; i < count; ++i) {
    char name[MAX_STR_LENGTH + 1] = {};
    if (ex_get_variable_name(file, type, i + 1, name) < 0 || names[static_cast<std::size_t>(i)] != name) return false;
  }
  return true;
}

/// What one rank's file is about.
struct Contents {
  OutputMesh output;
  FieldNames names;
  std::string title;

  void define(const ExodusHandle& file) const {
    define_exodus_mesh(file, output.mesh, output.description, title);
    // Exodus refuses variables on nodes or cells that a file has none of: a rank may own no cells.
    if (output.mesh.nodes() > 0) {
      define_variables(file, EX_NODAL, names.nodal);
      define_variables(file, EX_ELEM_BLOCK, names.cell);
    }
    define_variables(file, EX_GLOBAL, names.global);
  }

  /// Is the file one of these contents, with at least `frames` frames?
  bool fit(const ExodusHandle& file, int frames) const {
    ex_init_params header{};
    const bool any = output.mesh.nodes() > 0;
    return ex_get_init_ext(file, &header) >= 0 && header.num_nodes == output.mesh.nodes() &&
           header.num_elem == output.mesh.cells() && ex_inquire_int(file, EX_INQ_TIME) >= frames &&
           (!any || (has_variables(file, EX_NODAL, names.nodal) && has_variables(file, EX_ELEM_BLOCK, names.cell))) &&
           has_variables(file, EX_GLOBAL, names.global);
  }

  void copy_frame(const ExodusHandle& from, const ExodusHandle& to, int frame) const {
    double time = 0;
    std::vector<double> values;
    const auto copy = [&](ex_entity_type type, int variable, int object, int64_t count) {
      values.resize(static_cast<std::size_t>(count));
      if (ex_get_var(from, frame, type, variable, object, count, values.data()) < 0)
        throw InputError(from.path() + ": a frame to go on with cannot be read");
      require_written(ex_put_var(to, frame, type, variable, object, count, values.data()), to, "a frame");
    };
    if (ex_get_time(from, frame, &time) < 0) throw InputError(from.path() + ": a frame's time cannot be read");
    require_written(ex_put_time(to, frame, &time), to, "a time");
    for (std::size_t v = 0; v < names.nodal.size() && output.mesh.nodes() > 0; ++v)
      copy(EX_NODAL, static_cast<int>(v) + 1, 1, output.mesh.nodes());
    for (std::size_t v = 0; v < names.cell.size(); ++v)
      for (std::size_t b = 0; b < output.cells.size(); ++b)
        if (!output.cells[b].empty())
          copy(EX_ELEM_BLOCK, static_cast<int>(v) + 1, static_cast<int>(b) + 1,
               static_cast<int64_t>(output.cells[b].size()));
    if (!names.global.empty()) copy(EX_GLOBAL, 1, 0, static_cast<int64_t>(names.global.size()));
  }

  /// Leaves the file at `path` its first frames only. NetCDF cannot drop the last ones: the first are copied.
  void drop_frames(const std::string& path, int frames) const {
    const std::string shorter = beside(path);
    {
      const ExodusHandle old(open(path, EX_READ), path);
      if (ex_inquire_int(old, EX_INQ_TIME) == frames) return;
      const ExodusHandle copy(create(shorter), shorter);
      define(copy);
      for (int frame = 1; frame <= frames; ++frame) copy_frame(old, copy, frame);
    }
    sync_to_disk(shorter);
    replace_file(shorter, path);
  }
};

}  // namespace

struct FieldFile::Implementation : Contents {
  std::string path;
  std::unique_ptr<ExodusHandle> file;
  int frame = 0;
};

FieldFile::FieldFile(const std::string& path, const LocalMesh& mesh, int rank, int ranks, const FieldNames& names,
                     const std::string& title)
    : implementation_(
          new Implementation{{OutputMesh(mesh, ranks), names, title}, file_name(path, rank, ranks), nullptr, 0}) {}

FieldFile::~FieldFile() = default;

void FieldFile::create() {
  Implementation& self = *implementation_;
  self.file = std::make_unique<ExodusHandle>(ixos::create(self.path), self.path);
  self.define(*self.file);
}

void FieldFile::verify(const FieldLength& keep) const {
  const Implementation& self = *implementation_;
  try_reading(self.path, [&] { self.fit(ExodusHandle(open(self.path, EX_READ), self.path), keep.frames); });
  const ExodusHandle file(open(self.path, EX_READ), self.path);
  if (!self.fit(file, keep.frames) || static_cast<double>(std::filesystem::file_size(self.path)) < keep.bytes)
    throw InputError(fmt::format(
        "{}: is not the file to go on with: it should have this mesh and {} frames; another --output begins a new one",
        self.path, keep.frames));
}

void FieldFile::resume(const FieldLength& keep) {
  Implementation& self = *implementation_;
  self.drop_frames(self.path, keep.frames);
  self.file = std::make_unique<ExodusHandle>(open(self.path, EX_WRITE), self.path);
  self.frame = keep.frames;
}

FieldLength FieldFile::length() const {
  std::error_code code;
  const auto bytes = std::filesystem::file_size(implementation_->path, code);
  return {implementation_->frame, code ? 0.0 : static_cast<double>(bytes)};
}

void FieldFile::sync() { sync_to_disk(implementation_->path); }

void FieldFile::write(double time, const std::vector<std::vector<double>>& nodal,
                      const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) {
  const ExodusHandle& file = *implementation_->file;
  const OutputMesh& output = implementation_->output;
  const int frame = ++implementation_->frame;
  require_written(ex_put_time(file, frame, &time), file, "a time");
  std::vector<double> values;
  for (std::size_t v = 0; v < nodal.size() && output.mesh.nodes() > 0; ++v) {
    values = output.nodal(nodal[v]);
    require_written(ex_put_var(file, frame, EX_NODAL, static_cast<int>(v) + 1, 1, static_cast<int64_t>(values.size()),
                               values.data()),
                    file, "a nodal field");
  }
  for (std::size_t v = 0; v < cell.size(); ++v)
    for (std::size_t b = 0; b < output.cells.size(); ++b) {
      values.clear();
      for (int c : output.cells[b]) values.push_back(cell[v][b][static_cast<std::size_t>(c)]);
      if (values.empty()) continue;
      require_written(ex_put_var(file, frame, EX_ELEM_BLOCK, static_cast<int>(v) + 1, static_cast<int64_t>(b) + 1,
                                 static_cast<int64_t>(values.size()), values.data()),
                      file, "a cell field");
    }
  if (!global.empty())
    require_written(ex_put_var(file, frame, EX_GLOBAL, 1, 0, static_cast<int64_t>(global.size()), global.data()), file,
                    "global variables");
  require_written(ex_update(file), file, "a frame");
}

}  // namespace ixos
