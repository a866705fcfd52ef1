#include "page.hpp"

#include <stdexcept>
#include <string_view>

#include "base64.hpp"
#include "gzip.hpp"
#include "name_text.hpp"
#include "page_template.hpp"

namespace discmc::host {
namespace {

// What the data comes before: all that looks for it.
constexpr std::string_view scripts = "<script type=\"application/base64\" id=\"module\">";

}  // namespace

void write_page(const std::string& name, const std::function<void(std::ostream&)>& write,
                std::ostream& out) {
  const std::string_view page = page_template();
  const std::size_t begin = page.find(scripts);
  if (begin == std::string_view::npos)
    throw std::runtime_error(
        "this discmc was built without the page: run scripts/setup web, and build it again");
  out << page.substr(0, begin) << "<script type=\"application/base64\" id=\"data\" data-name=\""
      << xml_attribute(name) << "\" data-encoding=\"gzip\">";
  Base64 base64(out);
  Gzip gzip(base64);
  std::ostream data(&gzip);
  write(data);
  gzip.finish();
  base64.finish();
  out << "</script>\n" << page.substr(begin);
}

}  // namespace discmc::host
