#include "simulation/board/avr_image.hpp"

#include <cxxabi.h>
#include <elf.h>
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "simulation/board/intel_hex.hpp"

namespace simulation {
namespace {

// avr-gcc's linker keeps the address spaces apart by these offsets.
constexpr std::uint32_t ram_offset = 0x800000;
constexpr std::uint32_t address_mask = 0xFFFF;
constexpr std::size_t largest_flash = 256 * 1024;

using Bytes = std::vector<std::uint8_t>;

void place(Bytes& flash, std::size_t address, const std::uint8_t* data, std::size_t size) {
  if (address + size > largest_flash) {
    throw std::runtime_error("it holds code at an address that no AVR has");
  }
  if (flash.size() < address + size) {
    flash.resize(address + size, 0xFF);
  }
  std::copy(data, data + size, flash.begin() + static_cast<std::ptrdiff_t>(address));
}

template <typename T>
T piece(const Bytes& file, std::size_t offset) {
  if (offset + sizeof(T) > file.size()) {
    throw std::runtime_error("the ELF file is cut short");
  }
  T value;
  std::memcpy(&value, file.data() + offset, sizeof value);
  return value;
}

void read_symbols(const Bytes& file, const Elf32_Ehdr& header, const Elf32_Shdr& table, AvrImage& image) {
  const auto names = piece<Elf32_Shdr>(file, header.e_shoff + table.sh_link * sizeof(Elf32_Shdr));
  for (std::size_t offset = 0; offset < table.sh_size; offset += sizeof(Elf32_Sym)) {
    const auto symbol = piece<Elf32_Sym>(file, table.sh_offset + offset);
    const std::size_t at = std::size_t{names.sh_offset} + symbol.st_name;
    if (symbol.st_name == 0 || symbol.st_shndx == SHN_UNDEF || at >= file.size()) {
      continue;
    }
    const auto* name = reinterpret_cast<const char*>(file.data() + at);
    const std::string text(name, strnlen(name, file.size() - at));
    const std::uint32_t value = symbol.st_value;
    image.symbols[text] = value >= ram_offset ? value & address_mask : value;
    if (ELF32_ST_TYPE(symbol.st_info) == STT_FUNC && value < ram_offset) {
      image.functions.emplace(value, text);
    }
  }
}

std::string section_name(const Bytes& file, const Elf32_Ehdr& header, const Elf32_Shdr& section) {
  const auto names = piece<Elf32_Shdr>(file, header.e_shoff + header.e_shstrndx * sizeof(Elf32_Shdr));
  const std::size_t at = std::size_t{names.sh_offset} + section.sh_name;
  return at < file.size() ? std::string(reinterpret_cast<const char*>(file.data() + at),
                                        strnlen(reinterpret_cast<const char*>(file.data() + at), file.size() - at))
                          : std::string();
}

// "GCC: (GNU) 5.4.0", the first of what the compilers of all parts have written.
void read_compiler(const Bytes& file, const Elf32_Shdr& comment, AvrImage& image) {
  for (std::size_t at = comment.sh_offset; at < comment.sh_offset + comment.sh_size && at < file.size(); ++at) {
    if (file[at] == 0) {
      return;
    }
    image.compiler += static_cast<char>(file[at]);
  }
}

std::string demangle(const std::string& name) {
  int status = 0;
  char* plain = abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status);
  std::string text = status == 0 ? plain : name;
  std::free(plain);
  return text.substr(0, text.find('('));
}

AvrImage parse_elf(const Bytes& file) {
  const auto header = piece<Elf32_Ehdr>(file, 0);
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_machine != EM_AVR) {
    throw std::runtime_error("it is not an ELF file for an AVR");
  }
  AvrImage image;
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    const auto segment = piece<Elf32_Phdr>(file, header.e_phoff + i * sizeof(Elf32_Phdr));
    if (segment.p_type != PT_LOAD || segment.p_filesz == 0 || segment.p_paddr >= ram_offset) {
      continue;
    }
    if (std::size_t{segment.p_offset} + segment.p_filesz > file.size()) {
      throw std::runtime_error("the ELF file is cut short");
    }
    place(image.flash, segment.p_paddr, file.data() + segment.p_offset, segment.p_filesz);
  }
  for (std::size_t i = 0; i < header.e_shnum; ++i) {
    const auto section = piece<Elf32_Shdr>(file, header.e_shoff + i * sizeof(Elf32_Shdr));
    if (section.sh_type == SHT_SYMTAB) {
      read_symbols(file, header, section, image);
    } else if (section.sh_type == SHT_PROGBITS && section_name(file, header, section) == ".comment") {
      read_compiler(file, section, image);
    }
  }
  return image;
}

AvrImage parse_hex(const Bytes& file) {
  AvrImage image;
  parse_intel_hex(file, [&](std::size_t address, const std::uint8_t* data, std::size_t size) {
    place(image.flash, address, data, size);
  });
  return image;
}

}  // namespace

std::optional<std::uint32_t> AvrImage::address_of(const std::string& symbol) const {
  const auto found = symbols.find(symbol);
  return found == symbols.end() ? std::nullopt : std::optional(found->second);
}

std::string AvrImage::place_of(std::uint32_t address) const {
  auto after = functions.upper_bound(address);
  if (after == functions.begin()) {
    return fmt::format("0x{:x}", address);
  }
  const auto& [start, name] = *--after;
  return start == address ? demangle(name) : fmt::format("{}+0x{:x}", demangle(name), address - start);
}

AvrImage load_avr_image(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path)) {
    throw std::runtime_error("no firmware image at '" + path + "'; `cmake --build build --target firmware` makes it");
  }
  const Bytes file{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  try {
    AvrImage image = path.ends_with(".hex") ? parse_hex(file) : parse_elf(file);
    if (image.flash.empty()) {
      throw std::runtime_error("it holds no code");
    }
    return image;
  } catch (const std::exception& reason) {
    throw std::runtime_error("cannot use the firmware image '" + path + "': " + reason.what());
  }
}

}  // namespace simulation
