// EEPROMs as files: those that can be read, and what is said of the others.
#include "simulation/eeprom/file.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

namespace simulation::eeprom {
namespace {

using Catch::Contains;

class File {
 public:
  explicit File(const std::string& text) : path_(std::filesystem::temp_directory_path() / "pilotfish_test_eeprom") {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~File() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

Bytes load(const std::string& text) {
  return load_file(File(text).path());
}

}  // namespace

TEST_CASE("Intel HEX is read, and what it does not hold is erased") {
  const Bytes contents = load(":040800000102030AE4\r\n:020010001122BB\n:00000001FF\n");
  REQUIRE(contents.size() == 4096);
  CHECK(Bytes(contents.begin() + 2048, contents.begin() + 2053) == Bytes{1, 2, 3, 10, 0xFF});
  CHECK(contents[0x10] == 0x11);
  CHECK(contents[0] == 0xFF);
}

TEST_CASE("4096 raw bytes are read") {
  std::string raw(4096, '\x00');
  raw[17] = 'a';
  const Bytes contents = load(raw);
  CHECK(contents[17] == 'a');
  CHECK(contents[4095] == 0);
}

TEST_CASE("a file that is no EEPROM is told from one, with the reason") {
  CHECK_THROWS_WITH(load_file("/nowhere/eeprom.hex"), Contains("no file at '/nowhere/eeprom.hex'"));
  CHECK_THROWS_WITH(load_file("/tmp"), Contains("no file at"));
  CHECK_THROWS_WITH(load(""), Contains("it is empty"));
  CHECK_THROWS_WITH(load("hello"), Contains("neither Intel HEX nor the 4096 raw bytes") && Contains("(5 bytes)"));
  CHECK_THROWS_WITH(load(":0208000001020"), Contains("no end record"));
  CHECK_THROWS_WITH(load(":02080000010203\n"), Contains("damaged: :02080000010203"));
  CHECK_THROWS_WITH(load(":02080000xx02F3\n"), Contains("not an Intel HEX file"));
  CHECK_THROWS_WITH(load(":020800000102F3\n"), Contains("no end record"));
  CHECK_THROWS_WITH(load(":020FFF000102ED\n:00000001FF\n"), Contains("is it the flash's file?"));
}

}  // namespace simulation::eeprom
