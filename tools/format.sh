# The layout of Java code, which the build checks: releng/java-format.xml.

cmd_format() {
  [[ $# -eq 0 ]] || usage_error "format takes no arguments: it lays out all Java code of this checkout"
  need_jdk
  need_maven
  say "Laying out the Java code"
  maven "$KEEP/logs/format.log" -N -q net.revelc.code.formatter:formatter-maven-plugin:format || fail "the code could not be laid out"
}
