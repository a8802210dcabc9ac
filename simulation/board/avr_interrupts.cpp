#include "simulation/board/avr_interrupts.hpp"

#include <algorithm>
#include <utility>

namespace simulation {
namespace {

// From the end of an instruction to the vector; a program counter of three bytes takes one more.
Cycle response_cycles(const avr_t& avr) {
  return avr.address_size == 3 ? 5 : 4;
}
constexpr Cycle extra_after_sleep = 4;
// RETI has these before it when its end is signalled.
Cycle return_cycles(const avr_t& avr) {
  return 2U + avr.address_size;
}

}  // namespace

AvrInterrupts::AvrInterrupts(avr_t& avr) : avr_(avr) {
  for (std::size_t i = 0; i < avr.interrupts.vector_count; ++i) {
    avr_int_vector_t* vector = avr.interrupts.vector[i];
    sources_.push_back(std::make_unique<Watched>(Watched{this, vector, {}, {vector->vector}}));
    on_signal<&Watched::on_running>(&vector->irq[AVR_INT_IRQ_RUNNING], *sources_.back());
  }
}

void AvrInterrupts::withdraw(avr_int_vector_t& vector) {
  vector.pending = 0;
  // simavr leaves the entry queued; many of them would fill its queue.
  auto& queue = avr_.interrupts.pending;
  const auto size = static_cast<std::uint16_t>(avr_int_pending_fifo_size);
  std::uint16_t to = queue.read;
  for (std::uint16_t from = queue.read; from != queue.write; from = static_cast<std::uint16_t>((from + 1) % size)) {
    if (queue.buffer[from] != &vector) {
      queue.buffer[to] = queue.buffer[from];
      to = static_cast<std::uint16_t>((to + 1) % size);
    }
  }
  queue.write = to;
  if (queue.read == queue.write && avr_.interrupt_state > 0) {
    avr_.interrupt_state = 0;
  }
}

bool AvrInterrupts::is_enabled(const avr_int_vector_t& vector) const {
  return avr_regbit_get(&avr_, vector.enable) != 0;
}

void AvrInterrupts::make_level(avr_int_vector_t& vector, std::function<bool()> asks) {
  watched(vector)->asks = std::move(asks);
}

void AvrInterrupts::update(avr_int_vector_t& vector) {
  update(*watched(vector));
}

void AvrInterrupts::serve() {
  avr_service_interrupts(&avr_);
  // The response took time. What fell due in it must act before the handler touches a timer, since simavr forgets due
  // compares when any compare register of that timer is written.
  avr_cycle_timer_process(&avr_);
}

void AvrInterrupts::serve_after_sleep() {
  wake_up_cycles_ = extra_after_sleep;
  serve();
  wake_up_cycles_ = 0;
}

std::vector<InterruptUse> AvrInterrupts::uses() const {
  std::vector<InterruptUse> all;
  for (const auto& source : sources_) {
    if (source->use.count > 0) {
      all.push_back(source->use);
    }
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.vector < b.vector; });
  return all;
}

AvrInterrupts::Watched* AvrInterrupts::watched(const avr_int_vector_t& vector) {
  for (const auto& source : sources_) {
    if (source->vector == &vector) {
      return source.get();
    }
  }
  throw std::runtime_error("an interrupt vector that simavr does not know");
}

void AvrInterrupts::Watched::on_running(std::uint32_t value) {
  value != 0 ? owner->begin(*this) : owner->end(*this);
}

void AvrInterrupts::begin(Watched& source) {
  source.entered = avr_.cycle;
  ++source.use.count;
  if (watch_ != nullptr) {
    watch_->enter(*source.vector);
  }
  avr_.cycle += response_cycles(avr_) + wake_up_cycles_;
}

void AvrInterrupts::end(Watched& source) {
  const Cycle taken = avr_.cycle + return_cycles(avr_) - source.entered;
  source.use.cycles += taken;
  source.use.longest = std::max(source.use.longest, taken);
  if (watch_ != nullptr) {
    watch_->leave();
  }
  if (source.asks) {
    update(source);
  }
}

void AvrInterrupts::update(Watched& source) {
  const bool asks = source.asks() && is_enabled(*source.vector);
  if (asks && source.vector->pending == 0) {
    raise(*source.vector);
  } else if (!asks && source.vector->pending != 0) {
    withdraw(*source.vector);
  }
}

}  // namespace simulation
