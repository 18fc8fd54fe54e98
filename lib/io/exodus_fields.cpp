#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/exodus_definition.hpp"
#include "io/exodus_variables.hpp"
#include "io/field_file.hpp"

namespace ixos {
namespace {

int make(const std::string& path) {
  const int id = create_exodus(path);
  require_created(id, path);
  return id;
}

std::string file_name(const std::string& path, int rank, int ranks) {
  if (ranks == 1) return path;
  return fmt::format("{}.{}.{:0{}}", path, ranks, rank, fmt::format("{}", ranks - 1).size());
}

/// The file of one rank.
class ExodusFields final : public FieldFile {
 public:
  ExodusFields(const std::string& path, FieldContents contents, const Comm& comm)
      : output_(std::move(contents.output)),
        names_(std::move(contents.names)),
        title_(std::move(contents.title)),
        path_(file_name(path, comm->getRank(), comm->getSize())) {}

  void create() override;
  void verify(const FieldLength& keep) const override;
  void resume(const FieldLength& keep) override;
  void write(double time, const std::vector<std::vector<double>>& nodal,
             const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) override;
  FieldLength length() const override;
  void sync() override { sync_to_disk(path_); }

 private:
  void define(const ExodusHandle& file) const;
  bool has_cells() const { return output_.mesh.nodes() > 0; }
  void copy_frame(const ExodusHandle& from, const ExodusHandle& to, int frame) const;
  void drop_frames(int frames) const;

  OutputMesh output_;
  FieldNames names_;
  std::string title_;
  std::string path_;
  std::unique_ptr<ExodusHandle> file_;
  int frame_ = 0;
};

void ExodusFields::define(const ExodusHandle& file) const {
  define_exodus_mesh(file, output_.mesh, output_.description, title_);
  define_variables(file, names_, has_cells());
}

void ExodusFields::copy_frame(const ExodusHandle& from, const ExodusHandle& to, int frame) const {
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
  for (std::size_t v = 0; v < names_.nodal.size() && has_cells(); ++v)
    copy(EX_NODAL, static_cast<int>(v) + 1, 1, output_.mesh.nodes());
  for (std::size_t v = 0; v < names_.cell.size(); ++v)
    for (std::size_t b = 0; b < output_.cells.size(); ++b)
      if (!output_.cells[b].empty())
        copy(EX_ELEM_BLOCK, static_cast<int>(v) + 1, static_cast<int>(b) + 1,
             static_cast<int64_t>(output_.cells[b].size()));
  if (!names_.global.empty()) copy(EX_GLOBAL, 1, 0, static_cast<int64_t>(names_.global.size()));
}

/// Leaves the file its first frames only. NetCDF cannot drop the last ones: the first are copied.
void ExodusFields::drop_frames(int frames) const {
  const std::string shorter = beside(path_);
  {
    const ExodusHandle old(open_exodus(path_, EX_READ), path_);
    if (ex_inquire_int(old, EX_INQ_TIME) == frames) return;
    const ExodusHandle copy(make(shorter), shorter);
    define(copy);
    for (int frame = 1; frame <= frames; ++frame) copy_frame(old, copy, frame);
  }
  sync_to_disk(shorter);
  replace_file(shorter, path_);
}

void ExodusFields::create() {
  file_ = std::make_unique<ExodusHandle>(make(path_), path_);
  define(*file_);
}

void ExodusFields::verify(const FieldLength& keep) const {
  require_frames(path_, ExodusFormat::Classic, {output_.mesh.nodes(), output_.mesh.cells()}, names_, keep);
}

void ExodusFields::resume(const FieldLength& keep) {
  drop_frames(keep.frames);
  file_ = std::make_unique<ExodusHandle>(open_exodus(path_, EX_WRITE), path_);
  frame_ = keep.frames;
}

FieldLength ExodusFields::length() const { return {frame_, bytes_of(path_)}; }

void ExodusFields::write(double time, const std::vector<std::vector<double>>& nodal,
                         const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) {
  const ExodusHandle& file = *file_;
  ++frame_;
  require_written(ex_put_time(file, frame_, &time), file, "a time");
  std::vector<double> values;
  for (std::size_t v = 0; v < nodal.size() && has_cells(); ++v) {
    values = output_.nodal(nodal[v]);
    require_written(ex_put_var(file, frame_, EX_NODAL, static_cast<int>(v) + 1, 1, static_cast<int64_t>(values.size()),
                               values.data()),
                    file, "a nodal field");
  }
  for (std::size_t v = 0; v < cell.size(); ++v)
    for (std::size_t b = 0; b < output_.cells.size(); ++b) {
      values = output_.cell(b, cell[v][b]);
      if (values.empty()) continue;
      require_written(ex_put_var(file, frame_, EX_ELEM_BLOCK, static_cast<int>(v) + 1, static_cast<int64_t>(b) + 1,
                                 static_cast<int64_t>(values.size()), values.data()),
                      file, "a cell field");
    }
  if (!global.empty())
    require_written(ex_put_var(file, frame_, EX_GLOBAL, 1, 0, static_cast<int64_t>(global.size()), global.data()), file,
                    "global variables");
  require_written(ex_update(file), file, "a frame");
}

}  // namespace

std::unique_ptr<FieldFile> exodus_fields(const std::string& path, FieldContents contents, const Comm& comm) {
  return std::make_unique<ExodusFields>(path, std::move(contents), comm);
}

}  // namespace ixos
