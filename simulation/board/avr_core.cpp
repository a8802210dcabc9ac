#include "simulation/board/avr_core.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace simulation {
namespace {

// simavr bounds a burst of instructions by the next timer anyway.
constexpr avr_cycle_count_t burst_limit = 1'000'000;
constexpr avr_cycle_count_t single_step = 1;
constexpr std::size_t most_complaints = 100;
constexpr std::size_t whole_data_space = 0x10000;
constexpr std::size_t whole_program_space =
    0x1000000;  // as far as RAMPZ and Z reach; never touched, so it costs nothing

// RJMP .-2 behind the last word wraps to address 0 as silicon does; simavr's own marker would print.
constexpr std::uint8_t wrap_to_zero[] = {0xFF, 0xCF};

AvrCore& core_of(avr_t* avr) {
  return *static_cast<AvrCore*>(avr->custom.data);
}

std::string formatted(const char* format, va_list arguments) {
  std::array<char, 400> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  std::string line(text.data());
  for (std::size_t escape; (escape = line.find("\x1b[")) != std::string::npos;) {
    line.erase(escape, line.find('m', escape) - escape + 1);
  }
  while (!line.empty() && (line.back() == '\n' || line.back() == ' ')) {
    line.pop_back();
  }
  return line;
}

void log(avr_t* avr, const int level, const char* format, va_list arguments) {
  if (avr == nullptr || avr->custom.data == nullptr || level == LOG_OUTPUT || level > LOG_WARNING) {
    return;
  }
  const std::string text = formatted(format, arguments);
  // Writing a compare register before the timer's mode is right on silicon, and a crash is reported in full before.
  if (text.find("UNSUPPORTED") == std::string::npos && text != "avr_sadly_crashed") {
    core_of(avr).complain(text);
  }
}

avr_t* make_chip(const std::string& mcu, AvrCore* core) {
  avr_global_logger_set(log);
  avr_t* avr = avr_make_mcu_by_name(mcu.c_str());
  if (avr == nullptr) {
    throw std::runtime_error("simavr does not know the chip '" + mcu + "'");
  }
  avr_init(avr);
  avr->custom.data = core;
  // The UARTs' habits of printing and of sleeping in real time.
  each_module<avr_uart_t>(*avr, "uart", [](avr_uart_t& uart) { uart.flags = 0; });
  // A wild write lands in simavr's array before its crash takes effect: let every address have a place.
  avr->data = static_cast<std::uint8_t*>(std::realloc(avr->data, whole_data_space));
  std::fill(avr->data + avr->ramend + 1, avr->data + whole_data_space, std::uint8_t{0});
  // The same for a wild ELPM.
  avr->flash = static_cast<std::uint8_t*>(std::realloc(avr->flash, whole_program_space));
  return avr;
}

void load(avr_t& avr, const AvrImage& image) {
  if (image.flash.size() > avr.flashend + 1) {
    throw std::runtime_error("the firmware image does not fit into the " + std::string(avr.mmcu));
  }
  std::copy(image.flash.begin(), image.flash.end(), avr.flash);
  std::copy(std::begin(wrap_to_zero), std::end(wrap_to_zero), avr.flash + avr.flashend + 1);
}

}  // namespace

AvrCore::AvrCore(const std::string& mcu, std::uint32_t frequency, const AvrImage& image)
    : avr_(make_chip(mcu, this)), code_size_(image.flash.size()) {
  avr_->frequency = frequency;
  avr_->vcc = avr_->avcc = avr_->aref = 5000;
  load(*avr_, image);
  interrupts_ = std::make_unique<AvrInterrupts>(*avr_);

  reset_hook_.kind = "reset hook";
  reset_hook_.avr = avr_;
  reset_hook_.core = this;
  reset_hook_.reset = [](avr_io_t* io) { static_cast<ResetHook*>(io)->core->after_reset(); };
  avr_io_t* last = avr_->io_port;
  while (last->next != nullptr) {
    last = last->next;
  }
  last->next = &reset_hook_;
}

AvrCore::~AvrCore() {
  // What simavr itself would leak.
  for (std::size_t i = 0; i < avr_->interrupts.vector_count; ++i) {
    avr_free_irq(avr_->interrupts.vector[i]->irq, AVR_INT_IRQ_COUNT);
  }
  avr_free_irq(avr_->interrupts.irq, AVR_INT_IRQ_COUNT);
  for (auto& reg : avr_->io) {
    avr_free_irq(reg.irq, AVR_IOMEM_IRQ_ALL + 1);
  }
  avr_terminate(avr_);
  std::free(avr_->irq_pool.irq);
  std::free(avr_);
}

void AvrCore::run(Cycle target) {
  if (now() >= target) {
    return;
  }
  if (was_asleep_ && avr_->state == cpu_Running) {
    interrupts_->serve_after_sleep();  // something from outside woke it up
  }
  is_stopping_ = false;
  // Bounds simavr's bursts, so that they end at the target.
  call_after<&AvrCore::reach_target>(*avr_, target - std::min(target, now()), *this);
  while (now() < target && !is_stopping_) {
    step(target);
  }
  cancel_call<&AvrCore::reach_target>(*avr_, *this);
  was_asleep_ = avr_->state == cpu_Sleeping;
}

void AvrCore::watch_locks() {
  lock_watch_ = std::make_unique<AvrLockWatch>(*avr_);
  interrupts_->tell(*lock_watch_);
}

void AvrCore::write(std::uint16_t address, std::uint8_t value) {
  constexpr avr_io_addr_t first_register = 0x20;
  if (address < first_register || address >= first_ram_address) {
    avr_->data[address] = value;
    return;
  }
  const auto& slot = avr_->io[AVR_DATA_TO_IO(address)];
  WriteHook{slot.w.c, slot.w.param}(*avr_, address, value);
  if (slot.irq != nullptr) {  // as simavr does after a write by the program
    avr_raise_irq(slot.irq + AVR_IOMEM_IRQ_ALL, value);
  }
}

int AvrCore::replace(std::uint16_t from, std::uint16_t to) {
  int count = 0;
  for (std::size_t at = 0; at + 1 < code_size_; at += 2) {
    if ((avr_->flash[at] | avr_->flash[at + 1] << 8) == from) {
      avr_->flash[at] = static_cast<std::uint8_t>(to);
      avr_->flash[at + 1] = static_cast<std::uint8_t>(to >> 8);
      ++count;
    }
  }
  return count;
}

void AvrCore::flip_flash(std::uint32_t address, int bit) {
  if (address <= avr_->flashend) {
    avr_->flash[address] = static_cast<std::uint8_t>(avr_->flash[address] ^ 1U << bit);
  }
}

void AvrCore::stick_ram(std::uint32_t address, int bit, bool is_high) {
  if (address >= first_ram_address && address <= avr_->ramend) {
    stuck_bits_.push_back({address, static_cast<std::uint8_t>(1U << bit), is_high});
    avr_->run_cycle_limit = single_step;
    force_stuck_bits();
  }
}

// No instruction reads a byte of RAM after having written it, so after each of them is often enough.
void AvrCore::force_stuck_bits() {
  for (const StuckBit& stuck : stuck_bits_) {
    std::uint8_t& byte = avr_->data[stuck.address];
    byte = static_cast<std::uint8_t>(stuck.is_high ? byte | stuck.mask : byte & ~stuck.mask);
  }
}

void AvrCore::stop() {
  is_stopping_ = true;
  avr_->run_cycle_count = 0;
}

void AvrCore::step(Cycle target) {
  if (avr_->run != avr_callback_run_raw) {
    reset(ResetKind::watchdog);  // what simavr's watchdog wants
    call_after<&AvrCore::reach_target>(*avr_, target - std::min(target, now()), *this);
  } else if (avr_->state == cpu_Running) {
    run_instructions();
    check_sanity();
  } else if (avr_->state == cpu_Sleeping) {
    sleep_on(target);
  } else {
    stay_frozen(target);
  }
}

void AvrCore::run_instructions() {
  const avr_flashaddr_t address = avr_->pc;
  avr_->pc = avr_run_one(avr_);
  if (lock_watch_) {
    lock_watch_->after_instruction(address);
  }
  force_stuck_bits();
  if (avr_->state == cpu_Sleeping) {
    fall_asleep();
  }
  avr_cycle_timer_process(avr_);
  if (avr_->interrupt_state < 0) {
    // SEI or RETI: exactly one more instruction, then service. simavr would let two pass, and so sleep for ever
    // on SEI, SLEEP, CLI.
    avr_->interrupt_state = avr_has_pending_interrupts(avr_) ? 1 : 0;
  } else if (avr_->interrupt_state > 0 && avr_->state == cpu_Running) {
    interrupts_->serve();
  }
}

void AvrCore::fall_asleep() {
  const std::uint8_t mode = avr_->data[sleep_mode_register];
  if ((mode & 1U) == 0) {
    avr_->state = cpu_Running;  // without SE, SLEEP does nothing
    return;
  }
  if ((mode & 0x0EU) != 0) {
    complain("SLEEP in another mode than idle; clocks are not stopped here");
  }
  if (avr_->sreg[S_I] == 0) {
    complain("SLEEP with interrupts off: only a reset ends it");
    avr_->state = cpu_Done;
  }
}

void AvrCore::sleep_on(Cycle target) {
  const auto* next = avr_->cycle_timers.timer;
  const Cycle until = std::max(now(), next != nullptr ? std::min<Cycle>(next->when, target) : target);
  statistics_.cycles_asleep += until - now();
  avr_->cycle = until;
  avr_cycle_timer_process(avr_);
  if (avr_->state == cpu_Running) {
    interrupts_->serve_after_sleep();
  }
}

void AvrCore::stay_frozen(Cycle target) {
  const auto* next = avr_->cycle_timers.timer;
  avr_->cycle = std::max(now(), next != nullptr ? std::min<Cycle>(next->when, target) : target);
  avr_cycle_timer_process(avr_);
}

void AvrCore::check_sanity() {
  const unsigned stack = avr_->data[R_SPL] | static_cast<unsigned>(avr_->data[R_SPH]) << 8;
  if (has_strayed_ || (avr_->pc < code_size_ && stack >= first_ram_address && stack <= avr_->ramend)) {
    return;
  }
  has_strayed_ = true;
  complain(avr_->pc >= code_size_ ? "the program counter has left the image" : "the stack pointer has left RAM");
}

void AvrCore::reset(ResetKind kind) {
  const avr_io_addr_t cause = avr_->reset_flags.porf.reg;
  std::uint8_t causes = avr_->data[cause];
  if (kind == ResetKind::power_on) {
    causes = 0;
    for (std::size_t address = first_ram_address; address <= avr_->ramend; ++address) {
      avr_->data[address] = garbage(static_cast<std::uint16_t>(address));
    }
    for (std::size_t i = 0; i < 32; ++i) {
      avr_->data[i] = garbage(static_cast<std::uint16_t>(i));
    }
  } else {
    ++statistics_.resets;
  }
  const auto flag = kind == ResetKind::power_on    ? avr_->reset_flags.porf
                    : kind == ResetKind::external  ? avr_->reset_flags.extrf
                    : kind == ResetKind::brown_out ? avr_->reset_flags.borf
                                                   : avr_->reset_flags.wdrf;
  causes = static_cast<std::uint8_t>(causes | 1U << flag.bit);
  if ((causes >> avr_->reset_flags.wdrf.bit & 1U) != 0) {
    // As long as WDRF is up the watchdog cannot be off; simavr starts it again from this note.
    each_module<avr_watchdog_t>(*avr_, "watchdog", [](avr_watchdog_t& watchdog) {
      watchdog.reset_context.wdrf = 1;
      watchdog.reset_context.avr_run = avr_callback_run_raw;
    });
  }
  avr_->run = avr_callback_run_raw;
  avr_reset(avr_);
  avr_->data[cause] = causes;  // the causes add up until the program clears them
  has_strayed_ = was_asleep_ = false;
  force_stuck_bits();
}

void AvrCore::after_reset() {
  avr_->run_cycle_limit = must_single_step() ? single_step : burst_limit;
  if (lock_watch_) {
    lock_watch_->after_reset();
  }
  // simavr forgets the registers but not what they had set.
  each_module<avr_timer_t>(*avr_, "timer", [](avr_timer_t& timer) {
    timer.mode = {};
    timer.wgm_op_mode_kind = avr_timer_wgm_none;
    timer.cs_div_value = 0;
    timer.tov_cycles = 0;
    timer.tov_base = 0;
    timer.tov_top = 0;
  });
  for (const auto& again : reset_calls_) {
    again();
  }
}

void AvrCore::complain(const std::string& text) {
  auto& all = statistics_.complaints;
  if (all.size() < most_complaints) {
    all.push_back("cycle " + std::to_string(now()) + ": " + text);
  }
}

std::uint8_t AvrCore::garbage(std::uint16_t address) {
  const std::uint32_t mixed = (address + 1U) * 2654435761U;
  return static_cast<std::uint8_t>(mixed >> 24);
}

}  // namespace simulation
