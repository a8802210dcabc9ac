// Whether an EEPROM, and a module that has started from it, are as they may be after a cut. Knows the layout by
// simulation/eeprom/layout.hpp and no line of the product.
#pragma once

#include <string>
#include <vector>

#include "simulation/eeprom/layout.hpp"
#include "simulation/powercut/module.hpp"

namespace simulation::powercut {

// How this version lays out its settings, and what a board does that has none stored.
struct Layout {
  std::uint8_t version = 0;
  std::uint8_t count = 0;
  eeprom::Bytes defaults;
};

// An EEPROM before anything is cut, and what must be true of it after the last start.
struct Scene {
  enum class Settings {
    kept,     // one of `allowed`, never a mix, in two sound copies; no fault
    lost,     // the defaults, LIMP, and an event; nothing is written over what is there
    missing,  // the defaults, no fault, nothing written: a new board
  };

  std::string name;
  eeprom::Bytes eeprom;
  Settings settings = Settings::kept;
  std::vector<eeprom::Bytes> allowed;  // in force
  std::vector<eeprom::Bytes> stale;    // not in force, but may still stand in a copy
  std::size_t next_place = 0;          // of the log, where the next record goes
  bool may_tell_bad_copy = false;      // whether an event may say so; a copy that was never finished is not bad
};

// Each is empty if all is well, and says otherwise what is wrong.
// H-20: in each copy and in each record the first byte goes first and becomes FF, and comes back last of all.
std::string judge_order(const std::vector<EepromWrite>& writes);
// H-20: in the log, the places from `next_place` on hold new records, and at most one behind them is torn.
std::string judge_log_after_cut(const Scene& scene, const eeprom::Bytes& after);
// H-20, SB-3.9: as above, none torn, and this start is the newest that is told.
std::string judge_log(const Scene& scene, const eeprom::Bytes& after);
// H-20: the settings as the EEPROM holds them and as the module uses them.
std::string judge_settings(const Scene& scene, const Layout& layout, const eeprom::Bytes& after, const Answer& answer);

// Places in the list of settings, which are for ever; the last two are told on the bus (SB-0A.2).
constexpr std::size_t deadband_place = 0;
constexpr std::size_t sensitivity_place = 22;
constexpr std::size_t threshold_place = 23;

}  // namespace simulation::powercut
