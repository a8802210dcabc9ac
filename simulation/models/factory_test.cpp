#include "simulation/models/factory_test.hpp"

#include <utility>

#include "simulation/models/packets.hpp"

namespace simulation {
namespace {

constexpr int type_factory_test = 7;
constexpr std::size_t least_data = 3;
constexpr int last_page = 3;
constexpr std::uint8_t refused = 0xFF;
constexpr Time pause = 100us;  // from the other's TF to the answer

enum Command {
  read_register = 0,
  read_ram = 1,
  read_eeprom = 2,
  write_register = 3,
  write_ram = 4,
  write_eeprom = 5,
  reset = 6,
  select_page = 7,
  select_device = 8,
};

}  // namespace

void FactoryTest::hear_character(Time ended) {
  if (!answer_.empty()) {
    due_ = ended + longest_silence;  // SB-2.12: or silence, if no TF comes
  }
}

bool FactoryTest::take(const std::vector<std::uint8_t>& data, Time ended) {
  constexpr Time rounding = 1us;
  const bool is_own_voice = ended <= ignored_until_ + rounding;
  if (is_own_voice || data.size() < least_data || (data[0] >> 4 & 1) != static_cast<int>(module_)) {
    return false;
  }
  const Request request{data[0] & 0x0F, (data[0] & 0x40) << 1 | data[1], (data[0] & 0x20) << 2 | data[2]};
  if (!is_answered(request.command)) {
    return false;
  }
  const auto result = carry_out(request);
  if (!result) {
    return true;
  }
  answer_ = seal(type_factory_test, {(data[0] & 0x5F) | (*result & 0x80) >> 2, data[1], *result});
  answer_.push_back(end_of_turn);
  hear_character(ended);
  return false;
}

bool FactoryTest::is_answered(int command) const {
  return command <= select_device && (device_ == 0 || command == select_device);
}

// The data byte of the answer; nothing for a reset.
std::optional<std::uint8_t> FactoryTest::carry_out(const Request& request) {
  const auto address = static_cast<std::size_t>(request.address);
  const auto data = static_cast<std::uint8_t>(request.data);
  switch (request.command) {
    case read_register:
      return data_space_[address];
    case read_ram:
      return ram(request.address);
    case read_eeprom:
      return eeprom_[address];
    case write_register:
      return data_space_[address] = data;
    case write_ram:
      return ram(request.address) = data;
    case write_eeprom:
      return eeprom_[address] = data;
    case select_page:
      return set_page(request.data);
    case select_device:
      device_ = request.data;
      return data;
    default:
      return std::nullopt;
  }
}

std::uint8_t FactoryTest::set_page(int page) {
  if (page > last_page) {
    return refused;
  }
  page_ = page;
  return static_cast<std::uint8_t>(page);
}

void FactoryTest::hear_end_of_turn(Time ended) {
  if (!answer_.empty()) {
    due_ = ended + pause;
  }
}

std::vector<std::uint8_t> FactoryTest::take_answer() {
  due_ = never;
  return std::exchange(answer_, {});
}

void FactoryTest::begin_anew() {
  data_space_.fill(0);
  page_ = device_ = 0;
  take_answer();
}

}  // namespace simulation
