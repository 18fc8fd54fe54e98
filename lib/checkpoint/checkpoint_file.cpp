#include "checkpoint/checkpoint_file.hpp"

#include <fmt/format.h>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Map.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/agreement.hpp"
#include "checkpoint/seal.hpp"
#include "io/disk_file.hpp"

namespace ixos {
namespace {

/// Returns the position of the rank's owned degrees of freedom, or nodes, in arrays of all ranks.
Slab owned_slab(const DofSpace& space, int per_node) {
  const auto d = static_cast<unsigned long long>(space.dimension());
  const auto n = static_cast<unsigned long long>(per_node);
  const auto first = space.owned() > 0 ? static_cast<unsigned long long>(space.owned_map()->getMinGlobalIndex()) : 0;
  return {first / d * n, static_cast<unsigned long long>(space.owned()) / d * n,
          static_cast<unsigned long long>(space.global()) / d * n};
}

std::vector<long long> lengths_of_shares(const Comm& comm, long long mine) {
  std::vector<long long> lengths(static_cast<std::size_t>(comm->getSize()));
  Teuchos::gatherAll(*comm, 1, &mine, comm->getSize(), lengths.data());
  return lengths;
}

/// Returns the rank's part of the concatenated shares.
Slab share_slab(const std::vector<long long>& lengths, int rank) {
  Slab slab;
  for (std::size_t r = 0; r < lengths.size(); ++r) {
    const auto length = static_cast<unsigned long long>(lengths[r]);
    if (static_cast<int>(r) < rank) slab.offset += length;
    if (static_cast<int>(r) == rank) slab.count = length;
    slab.total += length;
  }
  return slab;
}

std::string lengths_name(const char* name) { return std::string(name) + " lengths"; }
std::string globals_name(const char* name) { return std::string(name) + " of rigid bodies"; }

void check_finite(const char* name, const std::vector<double>& values) {
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
    throw InputError(fmt::format("\"{}\" has a value that is not finite", name));
}

/// Returns the numbers of the rank's own nodes in the mesh.
std::vector<long long> owned_nodes(const LocalMesh& mesh) {
  return {mesh.original_ids.begin(), mesh.original_ids.begin() + mesh.owned_nodes};
}

}  // namespace

CheckpointWriter::CheckpointWriter(const std::string& path, const DofSpace& space, const LocalMesh& mesh, double bytes)
    : path_(path), space_(space) {
  double all = bytes + 8.0 * mesh.owned_nodes;
  space.sum(&all, 1);
  file_ = std::make_unique<Hdf5Output>(beside(path), space.comm(), seal_bytes, static_cast<unsigned long long>(all));
  file_->put("ranks", static_cast<double>(space.comm()->getSize()));
  const std::vector<long long> nodes = owned_nodes(mesh);
  file_->put("nodes", nodes.data(), owned_slab(space, 1));
}

void CheckpointWriter::scalar(const char* name, double& value) {
  if (space_.comm()->getSize() > 1) Teuchos::broadcast(*space_.comm(), 0, &value);
  file_->put(name, value);
}

void CheckpointWriter::field(const char* name, std::vector<double>& values, Extent extent) {
  const bool present = space_.maximum(values.empty() ? 0 : 1) > 0;
  // A rank may own no nodes, or none that are constrained and have reactions.
  const std::vector<double> zero(values.empty() && present ? static_cast<std::size_t>(space_.owned()) : 0, 0.0);
  file_->put(name, values.empty() ? zero.data() : values.data(),
             present ? owned_slab(space_, space_.dimension()) : Slab{});
  const auto globals = static_cast<unsigned long long>(space_.globals().numbers);
  if (extent == Extent::Owned || globals == 0 || !present) return;
  const bool first = space_.comm()->getRank() == 0;  // alike on all ranks
  file_->put(globals_name(name).c_str(), values.data() + space_.first_global(), Slab{0, first ? globals : 0, globals});
}

void CheckpointWriter::share(const char* name, std::vector<double>& values) {
  const Comm& comm = space_.comm();
  const std::vector<long long> lengths = lengths_of_shares(comm, static_cast<long long>(values.size()));
  const auto rank = static_cast<unsigned long long>(comm->getRank());
  file_->put(lengths_name(name).c_str(), &lengths[rank], Slab{rank, 1, lengths.size()});
  file_->put(name, values.data(), share_slab(lengths, comm->getRank()));
}

void CheckpointWriter::publish() {
  std::vector<FilePiece> pieces = file_->close();
  on_first_rank(space_.comm(), [&] {
    seal(beside(path_), std::move(pieces));
    replace_file(beside(path_), path_);
  });
}

void write_checkpoint_file(const std::string& path, const DofSpace& space, const LocalMesh& mesh,
                           const std::function<void(Record&)>& transfer) {
  CheckpointSize size;
  transfer(size);
  try {
    CheckpointWriter writer(path, space, mesh, size.bytes());
    transfer(writer);
    writer.publish();
  } catch (...) {  // a FileError, or what a state of the program throws
    std::error_code code;
    if (space.comm()->getRank() == 0) std::filesystem::remove(beside(path), code);
    throw;
  }
}

CheckpointReader::CheckpointReader(const std::string& path, const DofSpace& space, const LocalMesh& mesh)
    : space_(space) {
  const std::vector<long long> nodes = owned_nodes(mesh);
  together<InputError>(space.comm(), [&] {
    file_ = std::make_unique<Hdf5Input>(path);
    const double ranks = file_->number("ranks");
    if (!(ranks >= 1 && ranks < 1e9)) throw InputError(path + ": \"ranks\" is not a number of ranks");
    ranks_ = static_cast<int>(ranks);
    if (file_->length("nodes") != static_cast<unsigned long long>(mesh.global_nodes))
      throw InputError(path + ": has another number of nodes than the mesh");
    same_partition_ = ranks_ == space.comm()->getSize() && file_->integers("nodes", owned_slab(space, 1)) == nodes;
  });
  same_partition_ = space.minimum(same_partition_ ? 1 : 0) > 0;
  if (!same_partition_) together<InputError>(space.comm(), [&] { find_places(nodes); });
}

void CheckpointReader::find_places(const std::vector<long long>& nodes) {
  const std::vector<long long> all = file_->integers("nodes", {0, file_->length("nodes"), 0});
  std::map<long long, std::size_t> places;
  for (std::size_t i = 0; i < all.size(); ++i) places[all[i]] = i;
  for (const long long node : nodes) {
    const auto found = places.find(node);
    if (found == places.end()) throw InputError("the checkpoint has no node " + std::to_string(node + 1));
    place_.push_back(found->second);
  }
}

void CheckpointReader::scalar(const char* name, double& value) {
  together<InputError>(space_.comm(), [&] { value = file_->number(name); });
}

void CheckpointReader::text(const char* name, std::string& value) {
  together<InputError>(space_.comm(), [&] { value = file_->text(name); });
}

bool CheckpointReader::has_section(const std::string& name) const {
  return space_.minimum(file_->has_group(name) ? 1 : 0) > 0;
}

void CheckpointReader::enter(const std::string& name) {
  together<InputError>(space_.comm(), [&] { file_->enter(name); });
}

void CheckpointReader::field(const char* name, std::vector<double>& values, Extent extent) {
  bool present = false;
  together<InputError>(space_.comm(), [&] {
    const unsigned long long length = file_->length(name);
    present = length > 0;
    if (present && length != static_cast<unsigned long long>(space_.global()))
      throw InputError(std::string("\"") + name + "\" has another length than the model");
    values.assign(static_cast<std::size_t>(!present                  ? 0
                                           : extent == Extent::Local ? space_.local()
                                                                     : space_.owned()),
                  0.0);
    if (!present) return;
    if (same_partition_) {
      const std::vector<double> mine = file_->numbers(name, owned_slab(space_, space_.dimension()));
      std::copy(mine.begin(), mine.end(), values.begin());
    } else {
      const std::vector<double> all = file_->numbers(name, {0, length, 0});
      const auto d = static_cast<std::size_t>(space_.dimension());
      for (std::size_t node = 0; node < place_.size(); ++node)
        for (std::size_t i = 0; i < d; ++i) values[node * d + i] = all[place_[node] * d + i];
    }
    check_finite(name, values);
  });
  if (present && extent == Extent::Local) space_.update_ghosts(values.data());
  const auto globals = static_cast<unsigned long long>(space_.globals().numbers);
  if (extent == Extent::Owned || globals == 0 || !present) return;
  together<InputError>(space_.comm(), [&] {
    const std::vector<double> all = file_->numbers(globals_name(name).c_str(), {0, globals, 0});
    check_finite(globals_name(name).c_str(), all);
    std::copy(all.begin(), all.end(), values.begin() + space_.first_global());
  });
}

/// Returns the lengths of the shares of all ranks.
std::vector<long long> CheckpointReader::lengths(const char* name) const {
  const auto ranks = static_cast<unsigned long long>(space_.comm()->getSize());
  std::vector<long long> lengths = file_->integers(lengths_name(name).c_str(), {0, ranks, 0});
  for (long long length : lengths)
    if (length < 0) throw InputError(std::string("\"") + name + "\" has a share of negative length");
  return lengths;
}

void CheckpointReader::share(const char* name, std::vector<double>& values) {
  together<InputError>(space_.comm(),
                       [&] { values = file_->numbers(name, share_slab(lengths(name), space_.comm()->getRank())); });
}

void CheckpointReader::array(const char* name, std::vector<double>& values) {
  together<InputError>(space_.comm(), [&] {
    if (ranks_ != space_.comm()->getSize())
      throw InputError(fmt::format("\"{}\" was written by {} rank(s), and cannot be read by {}", name, ranks_,
                                   space_.comm()->getSize()));
    if (!same_partition_)
      throw InputError(
          fmt::format("\"{}\" was written with the nodes distributed or ordered otherwise, and cannot be "
                      "read by this program",
                      name));
    const Slab slab = share_slab(lengths(name), space_.comm()->getRank());
    if (slab.count != values.size())
      throw InputError(fmt::format("\"{}\" has {} values on rank {}, not {}", name, slab.count,
                                   space_.comm()->getRank(), values.size()));
    values = file_->numbers(name, slab);
    check_finite(name, values);
  });
}

void CheckpointReader::all_shares(const char* name, std::vector<double>& values) {
  together<InputError>(space_.comm(), [&] {
    values = file_->numbers(name, {0, file_->length(name), 0});
    check_finite(name, values);
  });
}

}  // namespace ixos
