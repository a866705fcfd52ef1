# The platforms on which golden.cpp must print the same numbers. Scripts `source` this file. A platform is a compiler
# and a machine.

source "$(dirname "${BASH_SOURCE[0]}")/../../../scripts/tools/clang.sh"

platforms=()
for compiler in gcc "clang-$oldest_clang" "clang-$newest_clang"; do
  platforms+=("$compiler x86-64" "$compiler x86-32")
done
for machine in aarch64 mips s390x cortex-m0plus cortex-m4 cortex-m33 rv32imac rv64imac; do
  platforms+=("gcc $machine")
done
# Disables all compiler-specific code: see lib/discmc/base/compiler.hpp.
platforms+=('gcc portable' "clang-$newest_clang portable")

# Properties of a machine besides its name.
declare -A remark=(
  [x86-32]='32 bits' [portable]='DISCMC_FORCE_PORTABLE' [aarch64]='qemu-user'
  [mips]='qemu-user, 32 bits, big-endian' [s390x]='qemu-user, 64 bits, big-endian'
  [cortex-m0plus]='firmware, microbit'
  [cortex-m4]='firmware, mps2-an386' [cortex-m33]='firmware, mps2-an505'
  [rv32imac]='firmware, virt' [rv64imac]='firmware, virt')

# Both signs of char, with -O2 only.
option_sets=(-O0 '-O2 -fsigned-char' '-O2 -funsigned-char' -O3 -Os)

# use_platform COMPILER MACHINE: sets `compile`, the compiler with the options of the machine, and `emulator`, which
# runs its programs. For firmware it also sets `board`, a folder of ports/boards/, and the sizes of its memories.
use_platform() {
  local family=$1
  compile=() emulator=() board=
  case $2 in
    x86-* | portable)
      compile=("${family/#clang/clang++}")
      [[ $family != gcc ]] || compile=(g++)
      case $2 in
        portable) compile+=(-DDISCMC_FORCE_PORTABLE) ;;
        *) compile+=(-m"${2#x86-}") ;;
      esac
      ;;
    aarch64 | mips | s390x)
      compile=("$2-linux-gnu-g++" -static)
      emulator=("qemu-$2")
      ;;
    *)
      use_target "$2" # from tests/proofs/object_code
      compile=("${tool}g++" "${machine[@]}")
      ;;
  esac
  # All memory that QEMU gives a board, because unoptimised code is larger.
  case $2 in
    cortex-m0plus) board=cortex_m/microbit flash=0+256K ram=0x20000000+16K ;;
    cortex-m4) board=cortex_m/mps2_an386 flash=0+4M ram=0x20000000+4M ;;
    cortex-m33) board=cortex_m/mps2_an505 flash=0x10000000+4M ram=0x38000000+4M ;;
    rv*) board=riscv/virt_${2%imac} flash=0x80000000+1M ram=0x80200000+4M ;;
  esac
  case $2 in
    cortex-m*) emulator=(qemu-system-arm -M "$(tr _ - <<<"${board##*/}")") ;;
    rv*) emulator=("qemu-system-riscv${2//[^0-9]/}" -M virt -bios none) ;;
  esac
  [[ -z $board ]] || emulator+=(-nographic -monitor none -serial none
    -chardev 'stdio,id=console,signal=off'
    -semihosting-config 'enable=on,target=native,chardev=console' -kernel)
}
