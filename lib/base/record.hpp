/// The named contents of an object in a checkpoint, or in memory.
#pragma once
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "base/error.hpp"

namespace ixos {

/// The part of a model that an array by degree of freedom covers: the rank's own nodes, or its ghosts too.
enum class Extent { Owned, Local };

/// Access to a checkpoint, for writing or reading, or to a Snapshot. An object's one function transfer(Record&) names
/// its members once for both. Collective: all ranks name the same things in the same order.
class Record {
 public:
  virtual ~Record() = default;

  virtual bool loading() const = 0;
  /// Returns, when loading, whether the scene equals the one of the checkpoint in all that bears on the motion.
  virtual bool same_scene() const = 0;
  /// Returns, when loading, whether the solvers are equal too.
  virtual bool same_solution() const = 0;
  /// Returns, when loading, whether the partition is equal. If not, shares of ranks must not be asked for.
  virtual bool same_partition() const = 0;
  bool exact() const { return same_scene() && same_solution() && same_partition(); }
  /// Returns whether the record stays in this process: the object that loads is the one that saved, and may keep what
  /// has not changed since.
  virtual bool in_memory() const { return false; }
  /// Returns, when loading, whether the present section has a section of that name; true when writing.
  virtual bool has_section(const std::string& /*name*/) const { return true; }

  /// Transfers a number or a truth value that is the same on all ranks; if it is not, the first rank's value is used.
  /// Throws InputError if a loaded value does not fit the type.
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
  /// Transfers an array by degree of freedom. If it is empty on some ranks only, zeros are written for those ranks.
  /// Loading sets the ghosts from their owners.
  virtual void field(const char* name, std::vector<double>& values, Extent extent) = 0;
  /// Transfers an array of any length that belongs to the rank.
  virtual void share(const char* name, std::vector<double>& values) = 0;
  /// Transfers an array that belongs to the rank and has its length when it loads. Throws InputError, on all ranks, if
  /// the length differs on any rank, if a value is not finite, or if another number of ranks wrote it.
  virtual void array(const char* name, std::vector<double>& values) { share(name, values); }
  /// Reads the arrays of all ranks that wrote with share(), one after the other. Loading only, on any partition. Throws
  /// InputError if a value is not finite.
  virtual void all_shares(const char* /*name*/, std::vector<double>& /*values*/) {
    throw std::logic_error("all_shares() is for loading");
  }

  /// A guard: names used during its life belong to its group.
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
