// bus/shark: bytes to frames.
#include "bus/shark/framer.hpp"

#include "tests/vectors/groups.hpp"
#include "tests/vectors/random.hpp"

namespace vectors {

using namespace bus::shark;

namespace {

void add_verdict(Record& record, const Verdict& verdict, const Framer& framer) {
  record.add(verdict.corrupt);
  record.add(verdict.silence);
  record.add(static_cast<uint8_t>(verdict.what));
  record.add(framer.is_nearly_complete());
  if (verdict.what == Verdict::What::frame) {
    const Frame& frame = framer.frame();
    record.add(frame.type);
    for (uint8_t i = 0; i < frame.length; ++i) {
      record.add(frame.data[i]);
    }
  }
}

// What a line carries on a bad day: now and then a sound packet, else anything.
class Soup {
 public:
  uint8_t next() {
    if (left_ > 0) {
      --left_;
      const uint8_t byte = left_ == 0 ? checksum(sum_) : static_cast<uint8_t>(random_.byte() | marker_bit);
      sum_ = static_cast<uint8_t>(sum_ + byte);
      return byte;
    }
    if (random_.one_in(8)) {
      return transmit_finished;
    }
    const uint8_t byte = random_.byte();
    if (!has_marker(byte)) {
      sum_ = byte;
      left_ = static_cast<uint8_t>(length_of(byte) + 1);
      if (random_.one_in(3)) {  // cut short, or with a wrong sum
        --left_;
      }
    }
    return byte;
  }

  Random& random() { return random_; }

 private:
  Random random_{6};
  uint8_t sum_ = 0;
  uint8_t left_ = 0;
};

}  // namespace

void wire_bytes(Record& record) {
  for (uint16_t value = 0; value <= 255; ++value) {
    const uint8_t byte = static_cast<uint8_t>(value);
    record.add(checksum(byte));
    record.add(has_marker(byte));
    record.add(type_of(byte));
    record.add(length_of(byte));
  }
  for (uint8_t type = 0; type < 16; ++type) {
    for (uint8_t length = 1; length <= longest_data; ++length) {
      record.add(start_byte(static_cast<Type>(type), length));
    }
  }
  record.known(checksum(0x00), 0xFF);
  record.known(checksum(0x7F), 0x80);
  record.known(checksum(static_cast<uint8_t>(0x05 + 0x87)), 0xF3);
  record.known(length_of(0x60), 7);
  record.known(start_byte(Type::spm_general, 7), 0x61);
  record.known(start_byte(Type::spm_hhp_data, 8), 0x73);
}

void framer(Record& record) {
  const uint16_t pauses[] = {285, 286, 287, 2999, 3000, 3035, 3036, 3037, 40000, 62000};
  Framer framer;
  Soup soup;
  Random& random = soup.random();
  base::Stamp now(65000);
  for (uint16_t i = 0; i < 30000; ++i) {
    now = now + base::Micros(random.one_in(16) ? random.any_of(pauses) : uint16_t{286});
    if (random.one_in(16)) {
      add_verdict(record, framer.poll(now), framer);
    }
    if (random.one_in(500)) {
      framer.reset();
    }
    const uint8_t byte = soup.next();
    const bool is_spoiled = random.one_in(64);
    add_verdict(record, framer.feed({byte, is_spoiled, now}), framer);
  }

  Framer fresh;
  fresh.feed({0x05, false, base::Stamp(65000)});
  fresh.feed({0x87, false, base::Stamp(65300)});
  record.known(fresh.is_nearly_complete(), 1);
  record.known(static_cast<uint8_t>(fresh.feed({0xF3, false, base::Stamp(64)}).what), 1);  // a frame
  record.known(fresh.frame().type, 5);
  record.known(fresh.frame().length, 1);
  record.known(fresh.frame().data[0], 7);
  record.known(fresh.poll(base::Stamp(3099)).silence, 0);  // 3 ms from the byte's end, 36 us after its stamp
  record.known(fresh.poll(base::Stamp(3100)).silence, 1);
}

}  // namespace vectors
