// SPDX-License-Identifier: MIT
#include "tests/bench/bench_stability.h"

#include "tests/bench/catalogue.h"

#include <ostream>

namespace hyrax::bench {

void stability(std::ostream& table, std::ostream& csv) {
    const std::streamsize table_precision = table.precision(2);
    const std::streamsize csv_precision = csv.precision(6);
    csv << "case,tolerance,integrator,error,fails\n";
    table << "| # | case | tolerance";
    for (const NamedColumn& column : columns) {
        table << " | " << column.name;
    }
    table << " |\n|---|---|---";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        table << "|---";
    }
    table << "|\n";

    std::array<int, columns.size()> failures{};
    for (const CatalogueCase& one : catalogue()) {
        table << "| " << one.id << " | " << one.text << " | " << one.tolerance;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const double error = one.measure(columns[i].column);
            const bool failed = fails(one, error);
            failures[i] += failed ? 1 : 0;
            table << " | " << (failed ? "[" : "") << error << (failed ? "]" : "");
            csv << one.id << ',' << one.tolerance << ',' << columns[i].name << ',' << error << ','
                << failed << '\n';
        }
        table << " |\n";
    }
    table << "| | failures of " << catalogue().size() << " | ";
    for (const int number : failures) {
        table << " | " << number;
    }
    table << " |\n";
    table.precision(table_precision);
    csv.precision(csv_precision);
}

}  // namespace hyrax::bench
