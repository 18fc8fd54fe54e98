#include "solve/loaded/muelu_factory.hpp"

#include <Thyra_MueLuPreconditionerFactory.hpp>
#include <Tpetra_CrsMatrix.hpp>

namespace ixos {

Teuchos::RCP<PreconditionerFactory> make_muelu_factory() {
  return Teuchos::rcp(new Thyra::MueLuPreconditionerFactory<double, LocalId, GlobalId, Node>);
}

}  // namespace ixos
