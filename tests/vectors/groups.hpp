// Groups of vectors: each runs one function of the product over many inputs and records what came out. Compiled for
// host and AVR from the same files, so whatever the two disagree about shows as a different record.
#pragma once

#include <stdint.h>

#include "tests/vectors/record.hpp"

namespace vectors {

struct Group {
  const char* name;
  void (*run)(Record& record);
};

constexpr uint8_t group_count = 31;
extern const Group groups[group_count];

// drivers/base
void instants(Record& record);
void stamps(Record& record);
void fields(Record& record);
void turn_sender(Record& record);
// bus/shark
void wire_bytes(Record& record);
void admissions(Record& record);
void general_decoding(Record& record);
void power_up_decoding(Record& record);
void hhp_data(Record& record);
void calibration_and_factory_test(Record& record);
void sacu_decoding(Record& record);
void general_encoding(Record& record);
void other_encodings(Record& record);
void framer(Record& record);
// faults
void link_supervisor(Record& record);
void event_ring(Record& record);
// spm
void setting_ranges(Record& record);
void settings_block(Record& record);
void profiles(Record& record);
void targets(Record& record);
void targets_at_extremes(Record& record);
void speedo(Record& record);
void ramps(Record& record);
void curves(Record& record);
void drive_gate(Record& record);
void fuel_gauge(Record& record);
void programmer(Record& record);
void board(Record& record);
void whole_module(Record& record);
void sleepy_module(Record& record);
void rough_module(Record& record);

}  // namespace vectors
