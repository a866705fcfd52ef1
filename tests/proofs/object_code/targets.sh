# The microcontrollers for which the library is proved and measured. Scripts `source` this file.

targets=(cortex-m0plus cortex-m3 cortex-m4 cortex-m7 cortex-m33 rv32imac rv64imac)

# use_target NAME: sets `tool`, the prefix of its tools, and `machine`, the compiler options. These options also select
# GCC's RISC-V libraries: -march=rv32imac_zicsr would link those of another machine.
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
