/// What a checkpoint holds of an object, by name.
#pragma once
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "base/error.hpp"

namespace ixos {

/// How much of a model an array by degree of freedom covers: the rank's own nodes, or its ghosts too.
enum class Extent { Owned, Local };

/// One function of an object, transfer(Record&), names its members once, for writing and for reading. Collective: all
/// ranks name the same things in the same order.
class Record {
 public:
  virtual ~Record() = default;

  virtual bool loading() const = 0;
  /// Loading: is the scene the one that it was written of, in all that bears on the motion?
  virtual bool same_scene() const = 0;
  /// Loading: and the solvers too?
  virtual bool same_solution() const = 0;
  /// Loading: is the partition the same? If not, shares of ranks must not be asked for.
  virtual bool same_partition() const = 0;
  bool exact() const { return same_scene() && same_solution() && same_partition(); }

  /// A number or a truth value, the same on all ranks; where it is not, the first rank's counts. Throws InputError
  /// where a loaded one does not fit the type.
  template <class T>
  void number(const char* name, T& value) {
    static_assert(std::is_arithmetic_v<T>);
    auto real = static_cast<double>(value);
    scalar(name, real);
    if constexpr (std::is_same_v<T, bool>) {
      value = real != 0;
    } else {
      if (std::is_integral_v<T> && !(std::abs(real) < static_cast<double>(std::numeric_limits<T>::max()) &&
                                     (real >= 0 || std::is_signed_v<T>)&&real == std::trunc(real)))
        throw InputError(std::string(name) + " is not a whole number in range");
      value = static_cast<T>(real);
    }
  }
  virtual void text(const char* name, std::string& value) = 0;
  /// An array by degree of freedom, empty on all ranks or zero where it is empty on some. Loading sets the ghosts from
  /// their owners.
  virtual void field(const char* name, std::vector<double>& values, Extent extent) = 0;
  /// An array of each rank's own, of any length.
  virtual void share(const char* name, std::vector<double>& values) = 0;

  /// What is named within the life of a Section is named in its group.
  class Section {
   public:
    Section(Record& record, const std::string& name) : record_(record) { record_.enter(name); }
    ~Section() { record_.leave(); }
    Section(const Section&) = delete;
    Section& operator=(const Section&) = delete;

   private:
    Record& record_;
  };

 private:
  virtual void scalar(const char* name, double& value) = 0;
  virtual void enter(const std::string& name) = 0;
  virtual void leave() = 0;
};

}  // namespace ixos
