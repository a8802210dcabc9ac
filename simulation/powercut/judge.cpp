#include "simulation/powercut/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace simulation::powercut {
namespace {

using eeprom::Bytes;

constexpr int started = 1;
constexpr int settings_lost = 25;
constexpr int settings_copy_bad = 26;
constexpr int power_module_fault = 8;

int value_of(const Bytes& values, std::size_t place) {
  return values.at(2 * place) | values.at(2 * place + 1) << 8;
}

bool are_same(const Bytes& one, const Bytes& other, std::size_t from, std::size_t until) {
  return std::equal(one.begin() + static_cast<std::ptrdiff_t>(from), one.begin() + static_cast<std::ptrdiff_t>(until),
                    other.begin() + static_cast<std::ptrdiff_t>(from));
}

bool is_untouched(const Scene& scene, const Bytes& after, std::size_t place) {
  return are_same(scene.eeprom, after, eeprom::place_at(place), eeprom::place_at(place + 1));
}

// New records from the scene's next place on.
std::vector<eeprom::Record> new_records(const Scene& scene, const Bytes& after) {
  const auto newest = eeprom::newest_record(scene.eeprom);
  unsigned sequence = newest ? newest->sequence + 1U : 0U;
  std::vector<eeprom::Record> records;
  for (std::size_t place = scene.next_place; records.size() < eeprom::places; ++place, ++sequence) {
    const auto record = eeprom::read_record(after, place % eeprom::places);
    if (!record || record->sequence != static_cast<std::uint16_t>(sequence)) {
      break;
    }
    records.push_back(*record);
  }
  return records;
}

std::string judge_places(const Scene& scene, const Bytes& after, std::size_t changed) {
  for (std::size_t i = changed; i < eeprom::places; ++i) {
    const std::size_t place = (scene.next_place + i) % eeprom::places;
    if (!is_untouched(scene, after, place)) {
      return fmt::format("the log's place {} is not what it was", place);
    }
  }
  return "";
}

bool is_one_of(const std::vector<Bytes>& some, const Bytes& values) {
  return std::find(some.begin(), some.end(), values) != some.end();
}

bool does_use(const Answer& answer, const Bytes& values) {
  return answer.speed_button_sensitivity == value_of(values, sensitivity_place) &&
         answer.joystick_switch_threshold == value_of(values, threshold_place);
}

std::string judge_kept(const Scene& scene, const Layout& layout, const Bytes& after, const Answer& answer) {
  for (std::size_t copy = 0; copy < eeprom::copies; ++copy) {
    const auto read = eeprom::read_copy(after, copy, layout.version, layout.count);
    if (!read.is_sound) {
      return fmt::format("copy {} of the settings is not whole after the start", copy);
    }
    if (!is_one_of(scene.allowed, read.values) && !is_one_of(scene.stale, read.values)) {
      return fmt::format("copy {} of the settings is neither the old ones nor the new ones", copy);
    }
  }
  const Bytes values = eeprom::values_in_force(after, layout.version, layout.count).value();
  if (!is_one_of(scene.allowed, values)) {
    return "settings are in force that were replaced long ago";
  }
  if (!does_use(answer, values)) {
    return "the module uses other settings than those stored";
  }
  return answer.limps || answer.system_state != 0 ? "the module reports a fault" : "";
}

std::string judge_defaults(const Scene& scene, const Layout& layout, const Bytes& after, const Answer& answer) {
  if (!are_same(scene.eeprom, after, 0, eeprom::place_at(0))) {
    return "something was written over the settings";
  }
  if (!does_use(answer, layout.defaults)) {
    return "the module does not use the defaults";
  }
  const auto records = new_records(scene, after);
  const bool tells_loss = std::any_of(records.begin(), records.end(),
                                      [](const eeprom::Record& record) { return record.code == settings_lost; });
  if (scene.settings == Scene::Settings::missing) {
    return answer.limps || answer.system_state != 0 || tells_loss ? "a new board reports a fault" : "";
  }
  if (!answer.limps || answer.system_state != power_module_fault) {
    return "the settings are lost and the module does not limp";
  }
  return tells_loss ? "" : "the settings are lost and the log does not say so";
}

}  // namespace

std::string judge_order(const std::vector<EepromWrite>& writes) {
  std::map<std::size_t, std::vector<EepromWrite>> by_first_byte;
  for (const EepromWrite& write : writes) {
    const std::size_t unit = write.address < eeprom::place_at(0) ? eeprom::copy_at(1) : eeprom::record_size;
    by_first_byte[write.address / unit * unit].push_back(write);
  }
  for (const auto& [first_byte, some] : by_first_byte) {
    const auto is_first_byte = [at = first_byte](const EepromWrite& write) { return write.address == at; };
    const bool goes_first = some.size() == 1 || !is_first_byte(some.front()) || some.front().after == 0xFF;
    const bool comes_last = is_first_byte(some.back()) && some.back().before == 0xFF;
    const bool stays_away = some.size() < 3 || std::none_of(some.begin() + 1, some.end() - 1, is_first_byte);
    if (!goes_first || !comes_last || !stays_away) {
      return fmt::format("what begins at address {} is not written in the order that was promised", first_byte);
    }
  }
  return "";
}

std::string judge_log_after_cut(const Scene& scene, const Bytes& after) {
  return judge_places(scene, after, new_records(scene, after).size() + 1);
}

std::string judge_log(const Scene& scene, const Bytes& after) {
  const auto records = new_records(scene, after);
  const auto begin = std::find_if(records.rbegin(), records.rend(),
                                  [](const eeprom::Record& record) { return record.code == started; });
  if (begin == records.rend()) {
    return "the log does not tell of the start";
  }
  const auto before = eeprom::newest_record(scene.eeprom);
  if (begin->argument != 0 || begin->starts <= (before ? before->starts : 0)) {
    return "the log tells of the start wrongly";
  }
  for (const eeprom::Record& record : records) {
    if (record.code != started && record.code != settings_lost && record.code != settings_copy_bad) {
      return fmt::format("the log tells of something else: event {}", record.code);
    }
    if (record.code == settings_copy_bad && !scene.may_tell_bad_copy) {
      return "the log tells of a bad copy, and there was none";
    }
    if (record.starts > begin->starts) {
      return "the log's starts are out of order";
    }
  }
  return judge_places(scene, after, records.size());
}

std::string judge_settings(const Scene& scene, const Layout& layout, const Bytes& after, const Answer& answer) {
  if (!answer.is_whole) {
    return "the remote was not answered as it must be";
  }
  const std::size_t copy_size = 4 + std::size_t{2} * layout.count + 2;
  if (!are_same(scene.eeprom, after, copy_size, eeprom::copy_at(1)) ||
      !are_same(scene.eeprom, after, eeprom::copy_at(1) + copy_size, eeprom::place_at(0))) {
    return "a byte that is nobody's was written";
  }
  return scene.settings == Scene::Settings::kept ? judge_kept(scene, layout, after, answer)
                                                 : judge_defaults(scene, layout, after, answer);
}

}  // namespace simulation::powercut
