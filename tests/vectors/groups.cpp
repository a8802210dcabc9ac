#include "tests/vectors/groups.hpp"

namespace vectors {

const Group groups[group_count] = {
    {"instants", instants},
    {"stamps", stamps},
    {"fields", fields},
    {"turn sender", turn_sender},
    {"wire bytes", wire_bytes},
    {"admissions", admissions},
    {"general decoding", general_decoding},
    {"power-up decoding", power_up_decoding},
    {"HHP data", hhp_data},
    {"calibration and factory test", calibration_and_factory_test},
    {"SACU decoding", sacu_decoding},
    {"general encoding", general_encoding},
    {"other encodings", other_encodings},
    {"framer", framer},
    {"link supervisor", link_supervisor},
    {"event ring", event_ring},
    {"setting ranges", setting_ranges},
    {"settings block", settings_block},
    {"profiles", profiles},
    {"targets", targets},
    {"targets at extremes", targets_at_extremes},
    {"speedo", speedo},
    {"ramps", ramps},
    {"curves", curves},
    {"drive gate", drive_gate},
    {"fuel gauge", fuel_gauge},
    {"programmer", programmer},
    {"board", board},
    {"whole module", whole_module},
    {"sleepy module", sleepy_module},
    {"rough module", rough_module},
};

}  // namespace vectors
