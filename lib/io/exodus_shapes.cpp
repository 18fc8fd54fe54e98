#include "io/exodus_shapes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <netcdf.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace ixos {
namespace {

/// Checks a variable, if the file has it.
void check_shape(const ExodusHandle& file, const std::string& name, const std::vector<std::string>& expected) {
  int variable = 0, count = 0;
  if (nc_inq_varid(file, name.c_str(), &variable) != NC_NOERR) return;
  bool same = nc_inq_varndims(file, variable, &count) == NC_NOERR && static_cast<std::size_t>(count) == expected.size();
  std::vector<int> dimensions(expected.size());
  same = same && nc_inq_vardimid(file, variable, dimensions.data()) == NC_NOERR;
  for (std::size_t i = 0; same && i < expected.size(); ++i) {
    int dimension = 0;
    same = nc_inq_dimid(file, expected[i].c_str(), &dimension) == NC_NOERR && dimension == dimensions[i];
  }
  if (!same)
    throw InputError(fmt::format("{}: is damaged: \"{}\" has not the dimension{} {}", file.path(), name,
                                 expected.size() == 1 ? "" : "s", fmt::join(expected, " and ")));
}

}  // namespace

void check_exodus_shapes(const ExodusHandle& file, const ex_init_params& header, int64_t most) {
  const auto check = [&](const std::string& name, const std::string& dimension) {
    check_shape(file, name, {dimension});
  };
  for (const char* axis : {"coordx", "coordy", "coordz"}) check(axis, "num_nodes");
  check("node_num_map", "num_nodes");
  check("elem_num_map", "num_elem");
  for (const char* part : {"prop1", "status"}) {
    check(fmt::format("eb_{}", part), "num_el_blk");
    check(fmt::format("ns_{}", part), "num_node_sets");
    check(fmt::format("ss_{}", part), "num_side_sets");
  }
  for (int64_t k = 1; k <= std::min<int64_t>(header.num_node_sets, most); ++k)
    check(fmt::format("node_ns{}", k), fmt::format("num_nod_ns{}", k));
  for (int64_t k = 1; k <= std::min<int64_t>(header.num_side_sets, most); ++k)
    for (const char* part : {"elem", "side"}) check(fmt::format("{}_ss{}", part, k), fmt::format("num_side_ss{}", k));
}

void check_exodus_cells(const ExodusHandle& file, int64_t blocks) {
  for (int64_t k = 1; k <= blocks; ++k)
    check_shape(file, fmt::format("connect{}", k),
                {fmt::format("num_el_in_blk{}", k), fmt::format("num_nod_per_el{}", k)});
}

}  // namespace ixos
