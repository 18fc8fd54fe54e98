#include "io/field_file.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/exodus_definition.hpp"
#include "io/output_mesh.hpp"

namespace ixos {
namespace {

int create(const std::string& path) {
  int word = 8, stored = 8;
  const int id = ex_create(path.c_str(), EX_CLOBBER | EX_LARGE_MODEL, &word, &stored);
  if (id < 0) throw FileError(path + ": cannot be written");
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

}  // namespace

struct FieldFile::Implementation {
  Implementation(const std::string& path, OutputMesh mesh) : file(create(path), path), output(std::move(mesh)) {}
  ExodusHandle file;
  OutputMesh output;
  int frame = 0;
};

FieldFile::FieldFile(const std::string& path, const LocalMesh& mesh, int rank, int ranks, const FieldNames& names,
                     const std::string& title)
    : implementation_(std::make_unique<Implementation>(file_name(path, rank, ranks), OutputMesh(mesh, ranks))) {
  const ExodusHandle& file = implementation_->file;
  define_exodus_mesh(file, implementation_->output.mesh, implementation_->output.description, title);
  // Exodus refuses variables on nodes or cells that a file has none of: a rank may own no cells.
  if (implementation_->output.mesh.nodes() > 0) {
    define_variables(file, EX_NODAL, names.nodal);
    define_variables(file, EX_ELEM_BLOCK, names.cell);
  }
  define_variables(file, EX_GLOBAL, names.global);
}

FieldFile::~FieldFile() = default;

void FieldFile::write(double time, const std::vector<std::vector<double>>& nodal,
                      const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) {
  const ExodusHandle& file = implementation_->file;
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
