/// NumPy arrays on memory of the library, without copies.
#pragma once
#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

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

}  // namespace ixos::python
