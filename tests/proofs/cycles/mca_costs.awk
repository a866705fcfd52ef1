# mca_costs.awk REPORT: of llvm-mca's report on such blocks the same lines as timings.awk.
/Code Region/ { split($NF, block, "_") }
/^Iterations:/ { iterations = $2 }
/^Total Cycles:/ { printf "%s %s %.2f\n", block[1], block[2], $3 / iterations }
