/// Checkpoints on the disk.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/record.hpp"
#include "discretization/dof_space.hpp"
#include "io/hdf5_file.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Writes a checkpoint to a path: `transfer` names its contents, twice, first to learn their size. Throws FileError,
/// and what `transfer` throws; then the previous file remains, and no other. Collective.
void write_checkpoint_file(const std::string& path, const DofSpace& space, const LocalMesh& mesh,
                           const std::function<void(Record&)>& transfer);

/// A record that computes the size of a checkpoint. Not collective.
class CheckpointSize final : public Record {
 public:
  bool loading() const override { return false; }
  bool same_scene() const override { return true; }
  bool same_solution() const override { return true; }
  bool same_partition() const override { return true; }
  void text(const char*, std::string& value) override { add(value.size()); }
  void field(const char*, std::vector<double>& values, Extent) override { add(8 * values.size()); }
  void share(const char*, std::vector<double>& values) override { add(8 * values.size()); }

  /// Returns an upper bound of the size of this rank's data and of HDF5's additions.
  double bytes() const { return bytes_; }

 private:
  void scalar(const char*, double&) override { add(8); }
  void enter(const std::string&) override { add(0); }
  void leave() override {}
  void add(std::size_t bytes) { bytes_ += static_cast<double>(bytes) + 512; }
  double bytes_ = 32768;
};

/// A record that writes a checkpoint beside its place, seals it, and moves it into place in one step: if any step
/// fails, the previous file remains. Failures show in publish(). Collective.
class CheckpointWriter final : public Record {
 public:
  /// Throws FileError if the file cannot be made, or the disk has no room for `bytes` (this rank's: see
  /// CheckpointSize).
  CheckpointWriter(const std::string& path, const DofSpace& space, const LocalMesh& mesh, double bytes);

  bool loading() const override { return false; }
  bool same_scene() const override { return true; }
  bool same_solution() const override { return true; }
  bool same_partition() const override { return true; }
  void text(const char* name, std::string& value) override { file_->put(name, value); }
  void field(const char* name, std::vector<double>& values, Extent extent) override;
  void share(const char* name, std::vector<double>& values) override;

  /// Throws FileError, on all ranks, if anything since the beginning could not be written.
  void publish();

 private:
  void scalar(const char* name, double& value) override;
  void enter(const std::string& name) override { file_->enter(name); }
  void leave() override { file_->leave(); }

  std::string path_;
  const DofSpace& space_;
  std::unique_ptr<Hdf5Output> file_;
};

/// A record that reads a checkpoint whose seal is intact (see seal_problem). On the partition that wrote it, every rank
/// reads its part; on another one, each rank picks its nodes' values by their numbers in the mesh. Throws InputError.
/// Collective.
class CheckpointReader final : public Record {
 public:
  CheckpointReader(const std::string& path, const DofSpace& space, const LocalMesh& mesh);

  bool loading() const override { return true; }
  bool same_scene() const override { return same_scene_; }
  bool same_solution() const override { return same_solution_; }
  bool same_partition() const override { return same_partition_; }
  bool has_section(const std::string& name) const override;
  void text(const char* name, std::string& value) override;
  void field(const char* name, std::vector<double>& values, Extent extent) override;
  void share(const char* name, std::vector<double>& values) override;
  void array(const char* name, std::vector<double>& values) override;
  void all_shares(const char* name, std::vector<double>& values) override;

  int ranks() const { return ranks_; }  ///< number of ranks that wrote it
  void set_same(bool scene, bool solution) {
    same_scene_ = scene;
    same_solution_ = solution;
  }

 private:
  void scalar(const char* name, double& value) override;
  void enter(const std::string& name) override;
  void leave() override { file_->leave(); }
  std::vector<long long> lengths(const char* name) const;
  void find_places(const std::vector<long long>& nodes);

  const DofSpace& space_;
  std::unique_ptr<Hdf5Input> file_;
  int ranks_ = 0;
  bool same_scene_ = true, same_solution_ = true;
  bool same_partition_ = false;
  std::vector<std::size_t> place_;  ///< for another partition: per owned node, the position of its values
};

}  // namespace ixos
