#include "rsi/ecu/application/section_record.hpp"

namespace rsi::application {

template class AlternatingRecord<SectionBytes>;

}  // namespace rsi::application
