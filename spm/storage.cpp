#include "spm/storage.hpp"

namespace spm {

LoadedSettings Storage::load(const SettingsBlock& first, const SettingsBlock& second) {
  const LoadedSettings loaded = read_settings(first, second);
  next_copy_ = loaded.next_copy;
  sequence_ = loaded.sequence;
  if (loaded.is_only_one) {
    begin(loaded.settings);  // H-20: two copies again, before the next mishap
    is_repairing_ = true;
  }
  return loaded;
}

bool Storage::store(const Settings& settings) {
  if (is_storing() && !is_repairing_) {
    return false;
  }
  begin(settings);
  return true;
}

// Whatever was being written goes to the same copy, which is not in use: it may be begun anew at any byte.
// Not inlined: the compiler would pay for it with registers of the loop.
__attribute__((noinline)) void Storage::begin(const Settings& settings) {
  is_repairing_ = false;
  block_ = make_settings_block(settings, static_cast<uint8_t>(sequence_ + 1U));
  written_ = 0;
  is_at_rest_ = false;
}

void Storage::note(base::Span<const faults::Event> events) {
  for (const faults::Event& event : events) {
    log_.add(event.code, event.argument);
  }
  is_at_rest_ = false;
}

// H-20: the mark away, everything else, the mark again.
base::Optional<ByteWrite> Storage::next_write() {
  if (!is_storing()) {
    const base::Optional<ByteWrite> write = log_.next_write();
    is_at_rest_ = !write && !log_.is_looking();
    return write;
  }
  ByteWrite write;
  write.address = address_of_copy(next_copy_);
  if (written_ == 0) {
    write.value = is_being_written;
    ++written_;
  } else if (written_ < settings_size) {
    write.address = static_cast<uint16_t>(write.address + written_);
    write.value = block_[written_];
    ++written_;
  } else {
    write.value = block_[0];
    written_ = is_idle;
    sequence_ = block_[3];
    next_copy_ = next_copy_ == 0 ? uint8_t{1} : uint8_t{0};
  }
  return write;
}

}  // namespace spm
