// An open file, closed at the end of its scope.
#pragma once

#include <unistd.h>

#include <utility>

namespace saddle {

/// A file descriptor of its own, or -1.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close_now(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  void set(int number) { number_ = number; }
  /// False if the system says only now that it could not write.
  bool close_now() {
    const int number = std::exchange(number_, -1);
    return number < 0 || close(number) == 0;
  }

 private:
  int number_;
};

}  // namespace saddle
