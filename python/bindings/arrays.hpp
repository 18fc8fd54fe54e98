/// NumPy arrays on memory of the library, without copies.
#pragma once
#include <pybind11/numpy.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace ixos::python {

using Shape = std::vector<pybind11::ssize_t>;

template <class T>
pybind11::array_t<T> read_only(pybind11::array_t<T> array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Returns an array of that shape on memory that belongs to `owner`, which the array keeps alive. It cannot be written.
template <class T>
pybind11::array_t<T> view(const T* values, Shape shape, const pybind11::object& owner) {
  return read_only(pybind11::array_t<T>(std::move(shape), values, owner));
}

/// Returns an array that takes the values over, so that nothing is copied.
template <class T>
pybind11::array_t<T> taken(std::vector<T> values, Shape shape) {
  auto kept = std::make_unique<std::vector<T>>(std::move(values));
  const T* data = kept->data();
  const pybind11::capsule owner(kept.release(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return pybind11::array_t<T>(std::move(shape), data, owner);
}

/// Returns an array of one dimension that takes the values over.
template <class T>
pybind11::array_t<T> taken(std::vector<T> values) {
  const auto size = static_cast<pybind11::ssize_t>(values.size());
  return taken(std::move(values), Shape{size});
}

using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Returns the letter of the kind of an array's elements, as NumPy has it: i, u, f, ...; 0 for what is no array.
inline char kind_of(const pybind11::array& array) { return array ? array.dtype().kind() : '\0'; }

/// Returns what a caller gave as an array of real numbers. Throws InputError with the place if it is none.
inline Numbers real_numbers(const pybind11::object& given, const std::string& place) {
  const auto array = pybind11::array::ensure(given);
  const char kind = kind_of(array);
  if (kind != 'f' && kind != 'i' && kind != 'u') throw InputError(place + ": an array of numbers is needed");
  return Numbers::ensure(array);
}

}  // namespace ixos::python
