#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "io/classic_layout.hpp"
#include "io/disk_file.hpp"
#include "io/exodus_definition.hpp"
#include "io/exodus_variables.hpp"
#include "io/field_file.hpp"
#include "io/guarded.hpp"

namespace ixos {
namespace {

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
        information_(std::move(contents.information)),
        path_(file_name(path, comm->getRank(), comm->getSize())) {}

  void create() override;
  void verify(const FieldLength& keep) const override;
  void resume(const FieldLength& keep) override;
  void write(double time, const std::vector<std::vector<double>>& nodal,
             const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) override;
  FieldLength length() const override;
  void sync() override { file_->sync(); }
  void close() override { file_->close(); }

 private:
  void define(const std::string& path) const;
  void define_here(const std::string& path) const;
  bool has_cells() const { return output_.mesh.nodes() > 0; }
  std::vector<std::string> expected_variables() const;
  void open(int frames);

  OutputMesh output_;
  FieldNames names_;
  std::string title_;
  std::vector<std::string> information_;
  std::string path_;
  std::unique_ptr<DiskFile> file_;
  ClassicLayout layout_;
  int frame_ = 0;
};

/// Has the library make the file: mesh, names, and the layout of a record.
void ExodusFields::define(const std::string& path) const {
  const std::size_t bytes = 64 * (output_.mesh.coordinates.size() + 9 * static_cast<std::size_t>(output_.mesh.cells()));
  write_apart(path, bytes, [&] { define_here(path); });
}

void ExodusFields::define_here(const std::string& path) const {
  const int id = create_exodus(path);
  require_created(id, path);
  ExodusHandle file(id, path);
  define_exodus_mesh(file, output_.mesh, output_.description, title_, information_);
  define_variables(file, names_, has_cells());
  if (has_cells() && !names_.cell.empty()) {
    // Otherwise the library makes the variables of cells at the first frame, and moves everything behind them.
    std::vector<int> present;
    for (const auto& cells : output_.cells) present.insert(present.end(), names_.cell.size(), cells.empty() ? 0 : 1);
    require_written(ex_put_truth_table(file, EX_ELEM_BLOCK, static_cast<int>(output_.cells.size()),
                                       static_cast<int>(names_.cell.size()), present.data()),
                    file, "variables");
  }
  require_written(file.close(), file, "the mesh");
}

/// The names of the variables that grow, as the library calls them, in the order of write().
std::vector<std::string> ExodusFields::expected_variables() const {
  std::vector<std::string> names{"time_whole"};
  for (std::size_t v = 1; v <= names_.nodal.size() && has_cells(); ++v)
    names.push_back(fmt::format("vals_nod_var{}", v));
  for (std::size_t v = 1; v <= names_.cell.size(); ++v)
    for (std::size_t b = 1; b <= output_.cells.size(); ++b)
      if (!output_.cells[b - 1].empty()) names.push_back(fmt::format("vals_elem_var{}eb{}", v, b));
  if (!names_.global.empty()) names.emplace_back("vals_glo_var");
  return names;
}

/// Opens the file to append frames behind these.
void ExodusFields::open(int frames) {
  file_ = std::make_unique<DiskFile>(path_, DiskFile::Mode::Change);
  layout_ = read_classic_layout(*file_, path_);
  frame_ = frames;
}

void ExodusFields::create() {
  define(path_);
  open(0);
}

void ExodusFields::verify(const FieldLength& keep) const {
  require_frames(path_, ExodusFormat::Classic, {output_.mesh.nodes(), output_.mesh.cells()}, names_, keep);
  const DiskFile file(path_, DiskFile::Mode::Read);
  const ClassicLayout layout = read_classic_layout(file, path_);
  std::vector<std::string> found;
  for (const auto& variable : layout.variables) found.push_back(variable.name);
  std::vector<std::string> expected = expected_variables();
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  if (found != expected || file.length() < layout.end(keep.frames))
    throw InputError(path_ +
                     ": cannot resume: frames are missing or damaged. Choose another --output to start new files");
}

void ExodusFields::resume(const FieldLength& keep) {
  open(keep.frames);
  write_record_count(*file_, keep.frames);
  file_->set_length(layout_.end(keep.frames));
}

FieldLength ExodusFields::length() const { return {frame_, bytes_of(path_)}; }

void ExodusFields::write(double time, const std::vector<std::vector<double>>& nodal,
                         const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) {
  std::map<std::string, std::vector<double>> rows{{"time_whole", {time}}, {"vals_glo_var", global}};
  for (std::size_t v = 0; v < nodal.size() && has_cells(); ++v)
    rows[fmt::format("vals_nod_var{}", v + 1)] = output_.nodal(nodal[v]);
  for (std::size_t v = 0; v < cell.size(); ++v)
    for (std::size_t b = 0; b < output_.cells.size(); ++b)
      rows[fmt::format("vals_elem_var{}eb{}", v + 1, b + 1)] = output_.cell(b, cell[v][b]);
  std::vector<char> record;
  record.reserve(layout_.record_bytes);
  for (const ClassicLayout::Variable& variable : layout_.variables) append_numbers(rows.at(variable.name), record);
  if (record.size() != layout_.record_bytes)
    throw FileError(path_ + ": a frame has another length than the file wants");
  // The count follows the record: readers never see half of one.
  file_->write_at(layout_.end(frame_), record.data(), record.size());
  write_record_count(*file_, frame_ + 1);
  ++frame_;
}

}  // namespace

std::unique_ptr<FieldFile> exodus_fields(const std::string& path, FieldContents contents, const Comm& comm) {
  return std::make_unique<ExodusFields>(path, std::move(contents), comm);
}

}  // namespace ixos
