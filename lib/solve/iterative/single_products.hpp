/// Products in single precision for a while.
#pragma once
#include "solve/assemblable_operator.hpp"

namespace ixos {

/// While it lives, products of an operator may be in single precision. Other operators than an AssemblableOperator
/// have one precision only.
class SingleProducts {
 public:
  explicit SingleProducts(const Operator& op) : op_(dynamic_cast<const AssemblableOperator*>(&op)) {
    if (op_ != nullptr) before_ = op_->set_precision(Precision::Single);
  }
  ~SingleProducts() {
    if (op_ != nullptr) op_->set_precision(before_);
  }
  SingleProducts(const SingleProducts&) = delete;
  SingleProducts& operator=(const SingleProducts&) = delete;

 private:
  const AssemblableOperator* op_;
  Precision before_ = Precision::Double;
};

}  // namespace ixos
