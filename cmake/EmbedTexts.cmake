# cmake -DOUTPUT=FILE.cpp "-DTEXTS=NAME;FILE;NAME;FILE..." -P EmbedTexts.cmake: writes the strings that
# report/EmbeddedTexts.h declares. References to source maps, which a page would request, are left out.
set(code "#include \"report/EmbeddedTexts.h\"\n\nnamespace ompl_mfa::report\n{\n")
while(TEXTS)
    list(POP_FRONT TEXTS name file)
    file(READ ${file} bytes HEX)
    # "//# sourceMappingURL" and "/*# sourceMappingURL" at the end of a file
    string(REGEX REPLACE "2f(2f|2a)2320736f757263654d617070696e6755524c.*$" "" bytes "${bytes}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
    string(APPEND code "    static const char ${name}_BYTES[] = {${bytes} 0};\n"
                       "    const std::string_view ${name}(${name}_BYTES, sizeof(${name}_BYTES) - 1);\n")
endwhile()
file(WRITE ${OUTPUT} "${code}}\n")
