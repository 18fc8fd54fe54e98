/// Failures that a program can catch.
///
/// Stable: InputError, FileError, MemoryError.
#pragma once
#include "base/error.hpp"
