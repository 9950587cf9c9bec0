// The limits of a run: --max-memory and --max-time. Work that can stop early asks here, so that it
// ends with what it has; the system refuses more memory than that, and is never asked to end us.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

namespace saddle {

/// A thing of which a run has too little.
enum class Shortage { None, Time, Memory };

/// Half of the memory that the machine has, or that its container may take; bytes.
std::uint64_t usual_memory_limit();

/// Lets the system refuse this process, and those that it starts, more memory than that. Called
/// once, at the start.
void limit_memory(std::uint64_t bytes);

/// Whether limit_memory() does more than stop refinement: not where a sanitizer needs addresses.
bool system_refuses_memory();

/// From now on.
void limit_time(double seconds);

/// The limit of time in seconds; infinite without one.
double time_for_work();

/// The limit of memory less what the program takes at rest, in bytes; without a limit all that can
/// be counted.
std::uint64_t memory_for_work();

/// The shortage of the run: more than half of memory_for_work() is taken, as the end of the work
/// needs about as much again, or its time is over. For work that can stop: it costs less than a
/// microsecond, and may be called from any thread.
Shortage shortage();

/// The time is over by so much that even what cannot stop early is ended, by an exception.
bool is_long_overtime();

/// Thrown by loops where is_long_overtime().
class Overtime : public std::exception {
 public:
  const char* what() const noexcept override { return "overtime"; }
};

/// "2.5 GB".
std::string bytes_text(std::uint64_t bytes);

/// The message of a std::bad_alloc: how much was asked for beside what was taken, if that is known.
std::string memory_refusal();
/// The message of Overtime.
std::string time_refusal();

}  // namespace saddle
