/// The gaps for which a law is defined.
#pragma once

namespace ixos {

enum class GapDomain {
  Positive,  ///< r > 0: a state with a gap r <= 0 is inadmissible
  All        ///< every gap; a negative one is an overlap
};

}  // namespace ixos
