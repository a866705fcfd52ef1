// Packed samples of 10 and 12 bits to rows of 16 bits.
//
// In the table P0 is the first sample, and [9:2] are its bits 9 to 2. The upper bits of a byte come
// first.
//
//                   byte 0    byte 1           byte 2           byte 3           byte 4
//   raw10           P0[9:2]   P1[9:2]          P2[9:2]          P3[9:2]          P3 P2 P1 P0 [1:0]
//   mono10p         P0[7:0]   P1[5:0] P0[9:8]  P2[3:0] P1[9:6]  P3[1:0] P2[9:4]  P3[9:2]
//   mono10pmsb      P0[9:2]   P0[1:0] P1[9:4]  P1[3:0] P2[9:6]  P2[5:0] P3[9:8]  P3[7:0]
//   raw12           P0[11:4]  P1[11:4]         P1[3:0] P0[3:0]
//   mono12p         P0[7:0]   P1[3:0] P0[11:8]  P1[11:4]
//   mono12pmsb      P0[11:4]  P0[3:0] P1[11:8]  P1[7:0]
//   mono12_packed   P0[11:4]  P1[3:0] P0[3:0]  P1[11:4]
#ifndef DISCMC_PACKED_SAMPLES_HPP
#define DISCMC_PACKED_SAMPLES_HPP

#include <stdint.h>

namespace discmc {

/// The packing of samples, by the names of the standards: raw... of MIPI CSI-2, mono... of the
/// Pixel Format Naming Convention of GenICam.
enum class Packing : uint8_t {
  raw10,          ///< the upper 8 bits of each of four samples, then their lower bits; V4L2: Y10P
  raw12,          ///< likewise for two samples; V4L2: Y12P
  mono10p,        ///< a string of bits, lowest first: USB3 Vision
  mono12p,        ///< likewise
  mono10pmsb,     ///< a string of bits, highest first: CoaXPress, TIFF; V4L2: Y10BPACK
  mono12pmsb,     ///< likewise
  mono12_packed,  ///< Mono12Packed: GigE Vision
};

/// The samples and bytes of a group.
struct PackedGroup {
  uint8_t samples, bytes;
};
constexpr PackedGroup group_of(Packing packing) {
  switch (packing) {
    case Packing::raw10:
    case Packing::mono10p:
    case Packing::mono10pmsb:
      return {4, 5};
    case Packing::raw12:
    case Packing::mono12p:
    case Packing::mono12pmsb:
    case Packing::mono12_packed:
      break;
  }
  return {2, 3};
}

/// The bytes that unpack() reads for this many samples: whole groups, including the last. Limit:
/// count <= 2^31.
constexpr uint32_t packed_bytes(Packing packing, uint32_t count) {
  const PackedGroup group = group_of(packing);
  return (count + group.samples - 1) / group.samples * group.bytes;
}

namespace detail::unpacking {

void raw10(const uint8_t* packed, uint32_t count, uint16_t* samples);
void raw12(const uint8_t* packed, uint32_t count, uint16_t* samples);
void mono10p(const uint8_t* packed, uint32_t count, uint16_t* samples);
void mono12p(const uint8_t* packed, uint32_t count, uint16_t* samples);
void mono10pmsb(const uint8_t* packed, uint32_t count, uint16_t* samples);
void mono12pmsb(const uint8_t* packed, uint32_t count, uint16_t* samples);
void mono12_packed(const uint8_t* packed, uint32_t count, uint16_t* samples);

}  // namespace detail::unpacking

/// Unpacks a row, or a part of a row that begins with a group. samples: room for count; it may
/// begin at `packed`, to unpack a row in place, and must not overlap it otherwise. Owner: the
/// caller. If the packing is a constant, the program links only its code. Cost: 7 to 12
/// instructions per sample on a Cortex-M4, 11 to 14 on a Cortex-M0+.
inline void unpack(Packing packing, const uint8_t* packed, uint32_t count, uint16_t* samples) {
  switch (packing) {
    case Packing::raw10:
      return detail::unpacking::raw10(packed, count, samples);
    case Packing::raw12:
      return detail::unpacking::raw12(packed, count, samples);
    case Packing::mono10p:
      return detail::unpacking::mono10p(packed, count, samples);
    case Packing::mono12p:
      return detail::unpacking::mono12p(packed, count, samples);
    case Packing::mono10pmsb:
      return detail::unpacking::mono10pmsb(packed, count, samples);
    case Packing::mono12pmsb:
      return detail::unpacking::mono12pmsb(packed, count, samples);
    case Packing::mono12_packed:
      return detail::unpacking::mono12_packed(packed, count, samples);
  }
}

}  // namespace discmc

#endif
