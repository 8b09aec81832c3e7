# cmake -DFOLDER=... -DFILES=a|b -DHEADER=... -DFUNCTION=... -DTYPE=... -DSTEM=ON|OFF -DOUTPUT=... -P EmbedFiles.cmake
# Writes the table that HachureEmbed.cmake describes: name and text of each file, as raw string literals.

string(REPLACE "|" ";" names "${FILES}")
set(rows "")
foreach(file IN LISTS names)
  file(READ ${FOLDER}/${file} text)
  set(name ${file})
  if(STEM)
    get_filename_component(name ${file} NAME_WE)
  endif()
  # A raw literal may hold 64 KiB at least; these files are far smaller.
  string(APPEND rows "    {\"${name}\", R\"__file__(${text})__file__\"},\n")
endforeach()
file(WRITE ${OUTPUT}
"#include <${HEADER}>

#include <iterator>

namespace {
constexpr ${TYPE} table[] = {
${rows}    {nullptr, nullptr}, // keeps the table non-empty
};
} // namespace

std::span<const ${TYPE}> ${FUNCTION}() { return {table, std::size(table) - 1}; }
")
