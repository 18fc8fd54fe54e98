/// The files of a scan.
#pragma once
#include <string>
#include <vector>

#include "study/scan/scan.hpp"

namespace ixos {

/// Writes scan.csv, a row for each run, and scan.json, what was asked. Throws FileError.
void write_scan(const Scan& scan, const std::vector<ScanRow>& rows, const ScanOptions& options);

/// Returns the rows as a table for a terminal: the varied values, the quantities, and the status of runs that failed.
std::string scan_text(const Scan& scan, const std::vector<ScanRow>& rows);

}  // namespace ixos
