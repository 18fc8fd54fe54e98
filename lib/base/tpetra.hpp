/// The Tpetra types that Ixos is built on, and the communicator. Only forward declarations are included.
#pragma once
#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <Tpetra_CrsGraph_fwd.hpp>
#include <Tpetra_CrsMatrix_fwd.hpp>
#include <Tpetra_Import_fwd.hpp>
#include <Tpetra_Map_fwd.hpp>
#include <Tpetra_MultiVector_fwd.hpp>
#include <Tpetra_Operator_fwd.hpp>
#include <Tpetra_Vector_fwd.hpp>

namespace ixos {

using LocalId = int;
using GlobalId = long long;
using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;
using Map = Tpetra::Map<LocalId, GlobalId>;
using Import = Tpetra::Import<LocalId, GlobalId>;
using Vector = Tpetra::Vector<double, LocalId, GlobalId>;
using MultiVector = Tpetra::MultiVector<double, LocalId, GlobalId>;
using CrsGraph = Tpetra::CrsGraph<LocalId, GlobalId>;
using CrsMatrix = Tpetra::CrsMatrix<double, LocalId, GlobalId>;
using Operator = Tpetra::Operator<double, LocalId, GlobalId>;

}  // namespace ixos
