// The linker leads calls of these functions here (see CMakeLists.txt), so that they can be counted
// without a word of it in the libraries. The names in quotes are the linker's.
#include "readings.h"

#include "point_bytes.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/scans/read_observation.h"

#define CHECKED_FILE \
  "_ZN9roomgraph11CheckedFileC1ERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE"
#define READ_SCAN "_ZN9roomgraph8readScanERNS_10ByteReaderERKNS_12ObjectHeaderERNS_9RangeScanE"
#define POINTS_OF "_ZN9roomgraph8pointsOfEPKhS1_S1_mm"

namespace roomgraph::test {

Readings readings;

void openFile(void* file, const std::string& name) asm("__real_" CHECKED_FILE);
void countFile(void* file, const std::string& name) asm("__wrap_" CHECKED_FILE);
void countFile(void* file, const std::string& name) {
  ++readings.files;
  openFile(file, name);
}

void decodeScan(ByteReader& in, const ObjectHeader& header,
                RangeScan& scan) asm("__real_" READ_SCAN);
void countScan(ByteReader& in, const ObjectHeader& header,
               RangeScan& scan) asm("__wrap_" READ_SCAN);
void countScan(ByteReader& in, const ObjectHeader& header, RangeScan& scan) {
  ++readings.scans;
  decodeScan(in, header, scan);
}

CloudPoints decodePoints(const std::uint8_t* x, const std::uint8_t* y, const std::uint8_t* z,
                         std::size_t count, std::size_t stride) asm("__real_" POINTS_OF);
CloudPoints countPoints(const std::uint8_t* x, const std::uint8_t* y, const std::uint8_t* z,
                        std::size_t count, std::size_t stride) asm("__wrap_" POINTS_OF);
CloudPoints countPoints(const std::uint8_t* x, const std::uint8_t* y, const std::uint8_t* z,
                        std::size_t count, std::size_t stride) {
  ++readings.clouds;
  return decodePoints(x, y, z, count, stride);
}

}  // namespace roomgraph::test
