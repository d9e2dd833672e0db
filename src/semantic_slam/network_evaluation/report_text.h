#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace semantic_slam {

// What reports are printed with; NaN is shown as "-".

std::string PercentText(double share);  // "78.1 %"
std::string NumberText(double value, int decimals);

// One line: a name and right-aligned cells.
void PrintTableRow(const std::string& name, const std::vector<std::string>& cells,
                   std::ostream& out);

}  // namespace semantic_slam
