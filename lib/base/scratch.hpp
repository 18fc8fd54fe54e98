/// Numbers for the points of one batch of cells or sides.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace ixos {

/// An array that a function fills for one batch after another. Up to `small` elements are on the stack: small models
/// spend more on an allocation than on the batch. The elements begin without a value.
template <class T, std::size_t small = 32>
class Scratch {
 public:
  explicit Scratch(std::size_t size) : size_(size) {
    if (size > small) many_.resize(size);
  }

  std::size_t size() const { return size_; }
  T* data() { return size_ > small ? many_.data() : few_.data(); }
  const T* data() const { return size_ > small ? many_.data() : few_.data(); }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }

 private:
  std::array<T, small> few_;
  std::vector<T> many_;
  std::size_t size_;
};

}  // namespace ixos
