# The microcontrollers that the library is proved and measured for; read by scripts with `source`.

targets=(cortex-m0plus cortex-m3 cortex-m4 cortex-m7 cortex-m33 rv32imac rv64imac)

# use_target NAME: sets `tool`, what the names of its tools begin with, and `machine`, the options
# that make the compiler work for it. GCC's RISC-V libraries are found by these options and no
# others: with -march=rv32imac_zicsr the link would take those of another machine.
use_target() {
  case $1 in
    cortex-m*) tool=arm-none-eabi- machine=(-mcpu="$1" -mthumb -mfloat-abi=soft) ;;
    rv32imac) tool=riscv64-unknown-elf- machine=(-march="$1" -mabi=ilp32) ;;
    rv64imac) tool=riscv64-unknown-elf- machine=(-march="$1" -mabi=lp64) ;;
    *)
      echo "no target '$1'; there are: ${targets[*]}" >&2
      return 2
      ;;
  esac
  case $1 in rv*) machine+=(-misa-spec=2.2 -mcmodel=medany) ;; esac
}
