#include "io/exodus_variables.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/guarded.hpp"
#include "io/hdf5_handle.hpp"

namespace ixos {
namespace {

void define(const ExodusHandle& file, ex_entity_type type, const std::vector<std::string>& names) {
  if (names.empty()) return;
  std::vector<char*> words;
  words.reserve(names.size());
  for (const std::string& name : names) words.push_back(const_cast<char*>(name.c_str()));
  require_written(ex_put_variable_param(file, type, static_cast<int>(names.size())), file, "variables");
  require_written(ex_put_variable_names(file, type, static_cast<int>(names.size()), words.data()), file, "variables");
}

bool has(const ExodusHandle& file, ex_entity_type type, const std::vector<std::string>& names) {
  int count = 0;
  ex_set_max_name_length(file, most_name_length);
  if (ex_get_variable_param(file, type, &count) < 0 || count != static_cast<int>(names.size())) return false;
  for (int i = 0; i < count; ++i) {
    char name[most_name_length + 1] = {};
    if (ex_get_variable_name(file, type, i + 1, name) < 0 || names[static_cast<std::size_t>(i)] != name) return false;
  }
  return true;
}

ExodusFormat format_of(const std::string& path) {
  std::array<char, 4> first{};
  DiskFile(path, DiskFile::Mode::Read).read_at(0, first.data(), first.size());
  return first == std::array<char, 4>{'\x89', 'H', 'D', 'F'} ? ExodusFormat::Hdf5 : ExodusFormat::Classic;
}

bool fits(const ExodusHandle& file, const ExodusSize& size, const FieldNames& names, int frames) {
  ex_init_params header{};
  return ex_get_init_ext(file, &header) >= 0 && header.num_nodes == size.nodes && header.num_elem == size.cells &&
         ex_inquire_int(file, EX_INQ_TIME) >= frames &&
         (size.nodes == 0 || (has(file, EX_NODAL, names.nodal) && has(file, EX_ELEM_BLOCK, names.cell))) &&
         has(file, EX_GLOBAL, names.global);
}

/// Opens a file to read. Throws InputError if it is missing or damaged.
int open_exodus(const std::string& path) {
  hdf5::prepare();
  int word = 8, stored = 0;
  float version = 0;
  const int id = std::filesystem::is_regular_file(path) ? ex_open(path.c_str(), EX_READ, &word, &stored, &version) : -1;
  if (id < 0)
    throw InputError(path +
                     ": cannot resume: frames are missing or damaged. Choose another --output to start new files");
  return id;
}

}  // namespace

void define_variables(const ExodusHandle& file, const FieldNames& names, bool has_cells) {
  if (has_cells) {
    define(file, EX_NODAL, names.nodal);
    define(file, EX_ELEM_BLOCK, names.cell);
  }
  define(file, EX_GLOBAL, names.global);
}

void require_frames(const std::string& path, ExodusFormat format, const ExodusSize& size, const FieldNames& names,
                    const FieldLength& keep) {
  const std::string misfit = fmt::format(
      "{}: cannot resume: the file should have this mesh, these fields and {} frames. Choose another --output to start "
      "new files",
      path, keep.frames);
  if (!is_file(path) || format_of(path) != format || bytes_of(path) < keep.bytes) throw InputError(misfit);
  // Only the child opens it: a library that cannot close a file ends badly.
  try_reading(path, [&] {
    if (!fits(ExodusHandle(open_exodus(path), path), size, names, keep.frames)) throw InputError(misfit);
  });
}

double bytes_of(const std::string& path) {
  std::error_code code;
  const auto bytes = std::filesystem::file_size(path, code);
  return code ? 0.0 : static_cast<double>(bytes);
}

}  // namespace ixos
