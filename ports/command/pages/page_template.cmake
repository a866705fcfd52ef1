# Writes the page as C++: cmake -DPAGE=discmc.html -DOUTPUT=page_template.cpp -P page_template.cmake
file(READ ${PAGE} bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
string(REPEAT "....." 16 row)
string(REGEX REPLACE "(${row})" "\\1\n" bytes "${bytes}")
file(WRITE ${OUTPUT} "#include \"pages/page.hpp\"

namespace {

constexpr unsigned char bytes[] = {
${bytes}};

}  // namespace

std::string_view discmc::command::page_template() {
  return {reinterpret_cast<const char*>(bytes), sizeof(bytes)};
}
")
