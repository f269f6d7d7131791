# The layout of Java code, which the build checks: releng/java-format.xml.

cmd_format() {
  [[ $# -eq 0 ]] || usage_error "format takes no arguments: it lays out all Java code of this checkout"
  need_jdk
  say "Laying out the Java code"
  lay_out '**/*.java'
}

# lay_out FILES: those in bundles, tests and releng that the pattern names.
lay_out() {
  need_maven
  maven "$KEEP/logs/format.log" -N -q net.revelc.code.formatter:formatter-maven-plugin:format "-Dformat.files=$1" \
    || fail "the code could not be laid out"
}
