# Writes the digest of the files TEXTS, as a C++ string, to OUT.
set(all "")
foreach(text IN LISTS TEXTS)
  file(SHA256 ${text} one)
  get_filename_component(name ${text} NAME)
  string(APPEND all "${name} ${one}\n")
endforeach()
string(SHA256 digest "${all}")
file(WRITE ${OUT} "\"${digest}\"\n")
