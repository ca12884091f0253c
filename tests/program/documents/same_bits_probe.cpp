// What the C library's elementary functions round to, as one number (same_bits.cmake).
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

int main() {
  std::uint64_t all = 0;
  for (int k = 1; k < 20000; ++k) {
    const volatile double x = 1e-3 * k;
    for (const double value : {std::exp(x), std::log(x), std::sin(x), std::pow(x, 1.7)})
      all = all * 6364136223846793005U + std::bit_cast<std::uint64_t>(value);
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(all));
}
