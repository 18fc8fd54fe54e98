#include <fmt/format.h>

#include <utility>

#include "base/agreement.hpp"
#include "io/disk_file.hpp"
#include "io/exodus_variables.hpp"
#include "io/field_file.hpp"
#include "io/gathered_mesh.hpp"
#include "io/global_order.hpp"
#include "io/guarded.hpp"
#include "io/hdf5_series.hpp"

namespace ixos {
namespace {

using Frame = std::vector<std::vector<double>>;  ///< by set, this rank's slab

/// Exodus on HDF5: the library defines mesh and names on the first rank; all ranks write the frames.
class Hdf5Fields final : public FieldFile {
 public:
  Hdf5Fields(std::string path, FieldContents contents, const Comm& comm);

  void create() override;
  void verify(const FieldLength& keep) const override;
  void resume(const FieldLength& keep) override;
  void write(double time, const std::vector<std::vector<double>>& nodal,
             const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) override;
  FieldLength length() const override { return {frame_, bytes_of(path_)}; }
  void sync() override { file_->sync(); }
  void close() override { file_->close(); }

 private:
  void define(const std::string& path) const;
  std::unique_ptr<Hdf5Series> open(const std::string& path, Hdf5Series::Mode mode) const {
    return std::make_unique<Hdf5Series>(path, comm_, sets_, mode);
  }
  void copy_first(int frames) const;

  std::string path_;
  FieldContents contents_;
  Comm comm_;
  GlobalOrder nodes_;
  std::vector<GlobalOrder> cells_;     ///< by block
  std::vector<Hdf5Series::Set> sets_;  ///< time, global, nodal by name, cells by name and block
  std::vector<Slab> slabs_;            ///< by set
  std::unique_ptr<Hdf5Series> file_;
  int frame_ = 0;
};

Hdf5Fields::Hdf5Fields(std::string path, FieldContents contents, const Comm& comm)
    : path_(std::move(path)),
      contents_(std::move(contents)),
      comm_(comm),
      nodes_(comm, contents_.output.description.node_ids, contents_.output.description.global_nodes) {
  const OutputMesh& output = contents_.output;
  auto first = output.description.cell_ids.begin();
  int offset = 0;
  for (std::size_t b = 0; b < output.mesh.blocks.size(); ++b) {
    std::vector<int> ids(first, first + output.mesh.blocks[b].cells());
    first += output.mesh.blocks[b].cells();
    for (int& id : ids) id -= offset;
    cells_.emplace_back(comm, ids, output.description.global_block_cells[b]);
    offset += output.description.global_block_cells[b];
  }
  const auto add = [&](const std::string& name, const std::string& scale, const Slab& slab) {
    if (slab.total == 0) return;  // of a block without cells
    sets_.push_back({name, slab.total, scale});
    slabs_.push_back(slab);
  };
  const auto on_first = [&](unsigned long long count) { return Slab{0, comm->getRank() == 0 ? count : 0, count}; };
  add("time_whole", "", on_first(1));
  add("vals_glo_var", "num_glo_var", on_first(contents_.names.global.size()));
  for (std::size_t v = 1; v <= contents_.names.nodal.size(); ++v)
    add(fmt::format("vals_nod_var{}", v), "num_nodes", nodes_.slab());
  for (std::size_t v = 1; v <= contents_.names.cell.size(); ++v)
    for (std::size_t b = 1; b <= cells_.size(); ++b)
      add(fmt::format("vals_elem_var{}eb{}", v, b), fmt::format("num_el_in_blk{}", b), cells_[b - 1].slab());
}

void Hdf5Fields::define(const std::string& path) const {
  const GatheredMesh whole = gathered(contents_.output, comm_);
  on_first_rank(comm_, [&] {
    // The library writes mesh and names itself, and does not survive a full disk: reserve the room before, twice, for
    // it empties the file that it makes.
    const auto room = 16 * (whole.mesh.coordinates.size() + 9 * static_cast<std::size_t>(whole.mesh.cells())) +
                      (sets_.size() + 64) * 4096;
    DiskFile(path, DiskFile::Mode::Create).lengthen(room);
    write_apart(path, room, [&] {
      const int id = create_exodus(path, ExodusFormat::Hdf5);
      require_created(id, path);
      ExodusHandle file(id, path);
      DiskFile(path, DiskFile::Mode::Change).reserve(room);
      define_exodus_mesh(file, whole.mesh, whole.description, contents_.title, contents_.information);
      define_variables(file, contents_.names, true);
      require_written(file.close(), file, "the mesh");
    });
    Hdf5Series::add(path, "time_step", sets_);
    DiskFile file(path, DiskFile::Mode::Change);
    file.set_length(file.length());
    file.close();
  });
}

void Hdf5Fields::create() {
  define(path_);
  file_ = open(path_, Hdf5Series::Mode::Write);
}

void Hdf5Fields::verify(const FieldLength& keep) const {
  long long cells = 0;
  for (const GlobalOrder& order : cells_) cells += static_cast<long long>(order.slab().total);
  on_first_rank(comm_, [&] {
    require_frames(path_, ExodusFormat::Hdf5, {static_cast<long long>(nodes_.slab().total), cells}, contents_.names,
                   keep);
    try_reading(path_, [&] { Hdf5Series::check(path_, sets_, static_cast<unsigned>(keep.frames)); });
  });
}

/// Replaces this file by one of its first frames. Does not touch what an unfinished frame left behind.
void Hdf5Fields::copy_first(int frames) const {
  const std::string copy = beside(path_);
  define(copy);
  {
    const auto from = open(path_, Hdf5Series::Mode::Read), to = open(copy, Hdf5Series::Mode::Write);
    for (int frame = 0; frame < frames; ++frame) {
      Frame values;
      values.reserve(sets_.size());
      for (std::size_t s = 0; s < sets_.size(); ++s)
        values.push_back(from->read(s, static_cast<unsigned>(frame), slabs_[s]));
      to->append(values, slabs_);
    }
    to->close();
  }
  on_first_rank(comm_, [&] {
    sync_to_disk(copy);
    replace_file(copy, path_);
  });
}

void Hdf5Fields::resume(const FieldLength& keep) {
  bool as_it_was = true;  // no frame was begun since: each makes the file longer before anything else
  on_first_rank(comm_, [&] { as_it_was = bytes_of(path_) == keep.bytes; });
  if (!first_problem(comm_, as_it_was ? "" : "it grew").empty()) copy_first(keep.frames);
  file_ = open(path_, Hdf5Series::Mode::Write);
  frame_ = keep.frames;
}

void Hdf5Fields::write(double time, const std::vector<std::vector<double>>& nodal,
                       const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) {
  Frame values{{time}, global};
  values.reserve(sets_.size());
  std::vector<std::vector<double>> shown;
  shown.reserve(nodal.size());
  for (const std::vector<double>& field : nodal) shown.push_back(contents_.output.nodal(field));
  for (std::vector<double>& field : nodes_.ordered(shown)) values.push_back(std::move(field));
  std::vector<Frame> blocks;
  blocks.reserve(cells_.size());
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    shown.clear();
    for (const auto& field : cell) shown.push_back(contents_.output.cell(b, field[b]));
    blocks.push_back(cells_[b].ordered(shown));
  }
  for (std::size_t v = 0; v < cell.size(); ++v)
    for (std::size_t b = 0; b < blocks.size(); ++b)
      if (cells_[b].slab().total > 0) values.push_back(std::move(blocks[b][v]));
  file_->append(values, slabs_);
  ++frame_;
}

}  // namespace

std::unique_ptr<FieldFile> hdf5_fields(const std::string& path, FieldContents contents, const Comm& comm) {
  return std::make_unique<Hdf5Fields>(path, std::move(contents), comm);
}

}  // namespace ixos
