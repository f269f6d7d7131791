# ./robotui new: the configuration of a control, plugins of a control from templates, and bundles from the example of their kind.

cmd_new_sources() {
  case ${1:-} in
    plugin | ioplugin) cmd_new_plugin "$@" ;;
    robot) cmd_new_robot "${@:2}" ;;
    rfic | uic | entity | display | ruic) new_bundle "$@" ;;
    *)
      say "robotui: new makes one of these, and not '${1:-nothing}':"
      say "  the configuration of a robot:  ./robotui new --rfic TYPE --name NAME FILE"
      say "  that of its control:           ./robotui new robot URDF [SRDF] [--in FOLDER]"
      say "  a bundle:                      ./robotui new rfic|uic|entity|display|ruic NAME [--in FOLDER]"
      say "  a plugin of a control:         ./robotui new plugin|ioplugin NAME [DIR]"
      exit 2
      ;;
  esac
}

# In the repository, derived lists of features follow at once, so that the tests of the architecture find nothing that a build would write;
# and lines are wrapped anew, as the name of the bundle is longer or shorter than that of the example.
new_bundle() {
  need_jdk
  "$JAVA_HOME/bin/java" "$ROOT/releng/NewBundle.java" "$ROOT" "$@" || exit $?
  [[ " $* " == *' --in '* ]] || { list_features && lay_out "*.$2/**/*.java"; }
}
