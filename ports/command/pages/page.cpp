#include "page.hpp"

#include <fstream>
#include <stdexcept>
#include <string_view>

#include "gzip.hpp"
#include "text/base64.hpp"
#include "text/name_text.hpp"

namespace discmc::command {
namespace {

// The data is inserted before this script, which reads it.
constexpr std::string_view scripts = "<script type=\"application/base64\" id=\"module\">";

// The page in two parts: before and after the text that was searched.
struct Parts {
  std::string_view head, scripts;
};

Parts parts_of_page() {
  const std::string_view page = page_template();
  const std::size_t begin = page.find(scripts);
  if (begin == std::string_view::npos)
    throw std::runtime_error(
        "this discmc was built without the page; run scripts/setup page and build again");
  return {page.substr(0, begin), page.substr(begin)};
}

std::string begin_data(const std::string& name) {
  return "<script type=\"application/base64\" id=\"data\" data-name=\"" + xml_attribute(name) + '"';
}

constexpr std::string_view end_data = "</script>\n";

// The policy of a page that needs no network.
constexpr std::string_view no_source = "default-src 'none';";

}  // namespace

void write_page(const std::string& name, const std::function<void(std::ostream&)>& write,
                std::ostream& out) {
  const Parts page = parts_of_page();
  out << page.head << begin_data(name) << " data-encoding=\"gzip\">";
  Base64 base64(out);
  Gzip gzip(base64);
  std::ostream data(&gzip);
  write(data);
  gzip.finish();
  base64.finish();
  out << end_data << page.scripts;
}

bool is_page(const std::filesystem::path& file) {
  const std::string_view head = page_template().substr(0, 4096);
  std::ifstream in(file, std::ios::binary);
  std::string begin(head.size(), '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return !head.empty() && begin == head;
}

std::string served_page(const std::string& name, const std::string& source, bool is_live) {
  const Parts page = parts_of_page();
  std::string text(page.head);
  const std::size_t policy = text.find(no_source);
  if (policy == std::string::npos)
    throw std::logic_error("the page has no policy for its connections");
  text.insert(policy + no_source.size(), " connect-src 'self';");
  text += begin_data(name) + " data-source=\"" + source + '"' + (is_live ? " data-live" : "") + '>';
  return text.append(end_data).append(page.scripts);
}

}  // namespace discmc::command
