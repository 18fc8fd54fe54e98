// Meshes in Exodus files, as the library itself reads them.
#include "io/exodus_definition.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "io/exodus_fixture.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/files.hpp"

namespace ixos {
namespace {

using test::file_failure;
using test::two_cells;

class ExodusDefinitionTest : public test::ExodusFolderTest {
 protected:
  /// Writes a file, and opens it to read.
  int written(const Mesh& mesh, const ExodusShare& share, const std::string& title = "title") const {
    ExodusHandle file(create_exodus(path("mesh.e")), path("mesh.e"));
    EXPECT_GE(static_cast<int>(file), 0);
    define_exodus_mesh(file, mesh, share, title);
    EXPECT_EQ(file.close(), 0);
    return open(path("mesh.e"));
  }
};

std::vector<int> plus_one(std::vector<int> numbers) {
  for (int& number : numbers) ++number;
  return numbers;
}

std::string name(const ExodusHandle& file, ex_entity_type type, int id) {
  std::array<char, 81> text{};
  EXPECT_GE(ex_get_name(file, type, id, text.data()), 0);
  return text.data();
}

/// The element type of a block and its connectivity, node numbers from 1.
std::pair<std::string, std::vector<int>> block(const ExodusHandle& file, int id) {
  std::array<char, MAX_STR_LENGTH + 1> type{};
  int cells = 0, nodes = 0, edges = 0, faces = 0, attributes = 0;
  EXPECT_GE(ex_get_block(file, EX_ELEM_BLOCK, id, type.data(), &cells, &nodes, &edges, &faces, &attributes), 0);
  std::vector<int> numbers(static_cast<std::size_t>(cells * nodes));
  if (cells > 0) {
    EXPECT_GE(ex_get_conn(file, EX_ELEM_BLOCK, id, numbers.data(), nullptr, nullptr), 0);
  }
  return {type.data(), numbers};
}

TEST_F(ExodusDefinitionTest, BlocksAndSetsAreNumberedFromOne) {
  const Mesh mesh = two_cells();
  const ExodusHandle file(written(mesh, test::whole(mesh), "two cells"), "");
  ex_init_params header{};
  ASSERT_GE(ex_get_init_ext(file, &header), 0);
  EXPECT_STREQ(header.title, "two cells");
  EXPECT_EQ(header.num_dim, 2);
  EXPECT_EQ(header.num_nodes, 6);
  EXPECT_EQ(header.num_elem, 2);
  EXPECT_EQ(header.num_elem_blk, 3);
  EXPECT_EQ(header.num_node_sets, 2);
  EXPECT_EQ(header.num_side_sets, 1);
  std::vector<double> x(6), y(6);
  ASSERT_GE(ex_get_coord(file, x.data(), y.data(), nullptr), 0);
  EXPECT_EQ(x, (std::vector<double>{0, 1, 2.5, 0, 1, 2.5}));
  EXPECT_EQ(y, (std::vector<double>{0, 0, 0, 1, 1, 1}));
  for (int id : {1, 2}) {
    const ElementBlock& expected = mesh.blocks[static_cast<std::size_t>(id - 1)];
    EXPECT_EQ(name(file, EX_ELEM_BLOCK, id), expected.name);
    EXPECT_EQ(block(file, id), std::pair(std::string("QUAD4"), plus_one(expected.nodes)));
  }
  EXPECT_EQ(name(file, EX_ELEM_BLOCK, 3), "empty");
  EXPECT_TRUE(block(file, 3).second.empty());
}

TEST_F(ExodusDefinitionTest, LinesBecomeRecordsOfAtMost80Bytes) {
  EXPECT_TRUE(exodus_records({}).empty());
  EXPECT_EQ(exodus_records({"short", ""}), (std::vector<std::string>{"short", ""}));
  const std::string exact(80, 'x');
  EXPECT_EQ(exodus_records({exact}), std::vector<std::string>{exact});
  EXPECT_EQ(exodus_records({exact + "yz"}), (std::vector<std::string>{exact, "  yz"}));
  // Characters of two bytes stay whole.
  std::string accents = "a", joined;
  for (int i = 0; i < 100; ++i) accents += "\xc3\xa9";
  const std::vector<std::string> records = exodus_records({accents});
  ASSERT_EQ(records.size(), 3U);
  for (const std::string& record : records) {
    EXPECT_LE(record.size(), 80U);
    EXPECT_NE(static_cast<unsigned char>(record.back()), 0xc3U);
    joined += &record == &records.front() ? record : record.substr(2);
  }
  EXPECT_EQ(joined, accents);
}

TEST_F(ExodusDefinitionTest, InformationRecordsReadBack) {
  for (ExodusFormat format : {ExodusFormat::Classic, ExodusFormat::Hdf5}) {
    const Mesh mesh = two_cells();
    {
      ExodusHandle file(create_exodus(path("info.e"), format), path("info.e"));
      define_exodus_mesh(file, mesh, test::whole(mesh), "title", {"scene: Ball", std::string(100, 'x')});
      EXPECT_EQ(file.close(), 0);
    }
    const ExodusHandle file(open(path("info.e")), "");
    ASSERT_EQ(ex_inquire_int(file, EX_INQ_INFO), 3);
    std::array<std::array<char, MAX_LINE_LENGTH + 1>, 3> texts{};
    std::array<char*, 3> records{texts[0].data(), texts[1].data(), texts[2].data()};
    ASSERT_GE(ex_get_info(file, records.data()), 0);
    EXPECT_STREQ(records[0], "scene: Ball");
    EXPECT_EQ(records[1], std::string(80, 'x'));
    EXPECT_EQ(records[2], "  " + std::string(20, 'x'));
  }
}

TEST_F(ExodusDefinitionTest, SidesNameTheirElementByItsNumberInTheFile) {
  const Mesh mesh = two_cells();
  const ExodusHandle file(written(mesh, test::whole(mesh)), "");
  EXPECT_EQ(name(file, EX_NODE_SET, 1), "ends");
  EXPECT_EQ(name(file, EX_NODE_SET, 2), "none");
  EXPECT_EQ(name(file, EX_SIDE_SET, 1), "top");
  std::vector<int> nodes(2), elements(2), sides(2);
  ASSERT_GE(ex_get_set(file, EX_NODE_SET, 1, nodes.data(), nullptr), 0);
  EXPECT_EQ(nodes, (std::vector<int>{1, 6}));
  int count = -1, factors = -1;
  ASSERT_GE(ex_get_set_param(file, EX_NODE_SET, 2, &count, &factors), 0);
  EXPECT_EQ(count, 0);
  ASSERT_GE(ex_get_set(file, EX_SIDE_SET, 1, elements.data(), sides.data()), 0);
  EXPECT_EQ(elements, (std::vector<int>{1, 2})) << "numbers continue from block to block";
  EXPECT_EQ(sides, (std::vector<int>{3, 3}));
}

TEST_F(ExodusDefinitionTest, HexahedraHaveThreeCoordinates) {
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {2, 3, 5};
  const Mesh mesh = box(shape);
  const ExodusHandle file(written(mesh, test::whole(mesh)), "");
  EXPECT_EQ(ex_inquire_int(file, EX_INQ_DIM), 3);
  std::array<std::vector<double>, 3> axes;
  axes.fill(std::vector<double>(8));
  ASSERT_GE(ex_get_coord(file, axes[0].data(), axes[1].data(), axes[2].data()), 0);
  for (std::size_t k = 0; k < mesh.coordinates.size(); ++k) EXPECT_EQ(axes[k % 3][k / 3], mesh.coordinates[k]) << k;
  EXPECT_EQ(block(file, 1), std::pair(std::string("HEX8"), plus_one(mesh.blocks[0].nodes)));
}

TEST_F(ExodusDefinitionTest, NumbersOfTheWholeMeshAreKept) {
  const Mesh mesh = two_cells();
  ExodusShare share;
  share.node_ids = {11, 13, 12, 40, 15, 16};
  share.cell_ids = {9, 7};
  const ExodusHandle file(written(mesh, share), "");
  std::vector<int> nodes(6), cells(2);
  ASSERT_GE(ex_get_id_map(file, EX_NODE_MAP, nodes.data()), 0);
  ASSERT_GE(ex_get_id_map(file, EX_ELEM_MAP, cells.data()), 0);
  EXPECT_EQ(nodes, share.node_ids);
  EXPECT_EQ(cells, share.cell_ids);
}

TEST_F(ExodusDefinitionTest, AFileOfASeriesDescribesTheWholeMesh) {
  const Mesh mesh = two_cells();
  ExodusShare share = test::whole(mesh);
  share.ranks = 4;
  share.global_nodes = 1000;
  share.global_cells = 500;
  share.global_block_cells = {300, 200, 0};
  const ExodusHandle file(written(mesh, share), "");
  int ranks = 0, here = 0;
  std::array<char, MAX_STR_LENGTH + 1> kind{};
  ASSERT_GE(ex_get_init_info(file, &ranks, &here, kind.data()), 0);
  EXPECT_EQ(ranks, 4);
  EXPECT_EQ(here, 1);
  EXPECT_STREQ(kind.data(), "p");
  int nodes = 0, cells = 0, blocks = 0, node_sets = 0, side_sets = 0;
  ASSERT_GE(ex_get_init_global(file, &nodes, &cells, &blocks, &node_sets, &side_sets), 0);
  EXPECT_EQ(nodes, 1000);
  EXPECT_EQ(cells, 500);
  EXPECT_EQ(blocks, 3);
  EXPECT_EQ(node_sets, 2);
  EXPECT_EQ(side_sets, 1);
  std::vector<int> ids(3), counts(3);
  ASSERT_GE(ex_get_eb_info_global(file, ids.data(), counts.data()), 0);
  EXPECT_EQ(ids, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(counts, share.global_block_cells);
}

// The format allows titles of 80 characters; the library's own limit of names is 32.
TEST_F(ExodusDefinitionTest, LongTitlesAreCutAndLongNamesAreNot) {
  Mesh mesh = two_cells();
  mesh.blocks[0].name = std::string(60, 'b');
  const ExodusHandle file(written(mesh, test::whole(mesh), std::string(200, 't')), "");
  ex_init_params header{};
  ASSERT_GE(ex_get_init_ext(file, &header), 0);
  EXPECT_EQ(std::string(header.title), std::string(80, 't'));
  ex_set_max_name_length(file, 80);
  EXPECT_EQ(name(file, EX_ELEM_BLOCK, 1), mesh.blocks[0].name);
}

TEST_F(ExodusDefinitionTest, AFileHasTheFormatThatIsAskedFor) {
  for (const auto& [format, start] :
       {std::pair<ExodusFormat, std::string>{ExodusFormat::Classic, "CDF\x02"}, {ExodusFormat::Hdf5, "\x89HDF"}}) {
    ExodusHandle file(create_exodus(path("empty.e"), format), path("empty.e"));
    ASSERT_GE(static_cast<int>(file), 0);
    EXPECT_EQ(file.close(), 0);
    EXPECT_EQ(test::contents(path("empty.e")).substr(0, 4), start);
  }
}

TEST_F(ExodusDefinitionTest, ANewFileReplacesALinkAndSparesItsTarget) {
  std::ofstream(path("target")) << "precious";
  std::filesystem::create_symlink(path("target"), path("link.e"));
  EXPECT_EQ(ExodusHandle(create_exodus(path("link.e")), path("link.e")).close(), 0);
  EXPECT_EQ(test::contents(path("target")), "precious");
  EXPECT_FALSE(std::filesystem::is_symlink(path("link.e")));
}

TEST_F(ExodusDefinitionTest, AFileThatCannotBeMadeIsNamedWithTheReason) {
  const std::string none = path("none/mesh.e");
  EXPECT_LT(create_exodus(none), 0);
  EXPECT_FALSE(std::filesystem::exists(path("none")));
  for (int reason : {ENOENT, EACCES})
    EXPECT_EQ(file_failure([&] {
                errno = reason;
                require_created(-1, none);
              }),
              none + ": cannot be written: " + std::strerror(reason));
  EXPECT_EQ(file_failure([&] { require_created(0, none); }), "");
}

// netCDF records positive numbers for errors of the system and negative ones for its own.
TEST_F(ExodusDefinitionTest, AFailedWriteIsNamedWithTheReason) {
  const ExodusHandle file(-1, "mesh.e");
  const auto message = [&](int status, int recorded, int leftover) {
    return file_failure([&] {
      ex_err("a function", "a message", recorded);
      errno = leftover;
      require_written(status, file, "a block");
    });
  };
  const std::string failed = "mesh.e: a block cannot be written";
  EXPECT_EQ(message(-1, ENOSPC, 0), failed + ": " + std::strerror(ENOSPC));
  EXPECT_EQ(message(-1, -33, EFBIG), failed + ": " + std::strerror(EFBIG)) << "the library lost the number";
  EXPECT_EQ(message(-1, -33, EINTR), failed) << "a leftover of something else";
  EXPECT_EQ(message(0, ENOSPC, ENOSPC), "");
  EXPECT_EQ(message(1, ENOSPC, ENOSPC), "") << "a warning";
}

}  // namespace
}  // namespace ixos
