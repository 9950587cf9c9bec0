#include "eval/kernels.h"

#include <array>
#include <cstdlib>
#include <string>

#include "base/error.h"

namespace saddle {

// One copy of kernel_loops.cpp each.
const Kernels& kernels_sse2();
const Kernels& kernels_sse2_without_fma();
const Kernels& kernels_avx2();
const Kernels& kernels_avx512();

namespace {

constexpr std::array kNames = {"sse2", "avx2", "avx512"};

/// FMA came with AVX2; we use either only with the other.
bool has_fma() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

CpuLevel forced_level(const std::string& wanted) {
  const Place place = {"SADDLE_CPU", wanted, {0, wanted.size()}};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (wanted != kNames[i]) continue;
    if (i < supported_level_count()) return static_cast<CpuLevel>(i);
    throw Error(Status::Input, "this processor does not have " + wanted, place,
                "leave SADDLE_CPU unset for the best that it has");
  }
  throw Error(Status::Input, "unknown CPU level '" + wanted + "'", place,
              "the levels are sse2, avx2 and avx512");
}

CpuLevel choose_level() {
  const char* const wanted = std::getenv("SADDLE_CPU");
  if (wanted != nullptr && *wanted != '\0') return forced_level(wanted);
  return static_cast<CpuLevel>(supported_level_count() - 1);
}

}  // namespace

CpuLevel cpu_level() {
  static const CpuLevel level = choose_level();
  return level;
}

std::size_t supported_level_count() {
  const bool avx2 = has_fma();
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return avx512 ? 3 : avx2 ? 2 : 1;
}

const char* level_name(CpuLevel level) {
  return kNames[static_cast<std::size_t>(level)];
}

const Kernels& kernels(CpuLevel level) {
  if (!has_fma()) return kernels_sse2_without_fma();
  return of_level(level, kernels_sse2, kernels_avx2, kernels_avx512)();
}

}  // namespace saddle
