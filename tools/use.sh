# What a checkout and a product have in common for those who use them: the help, and which RobotUI this is.

help_use() {
  cat <<'TEXT'
  ./robotui run [CONFIG...]     open the workbench (default: the demo, with two simulated robots). A recording (FILE.mcap, FILE.bag) in place
                                of a configuration is opened as a robot
      --text                    the text view, without a window
      --json                    JSON lines instead: one per port and second
      --show NAME               with --text or --json: also this robot UI, which starts only when it is shown
      --watch                   with --text or --json: take up what is changed in the files (the window always does, and asks)
      --script FILE             run this script (docs/scripting.md); with --text, end with it and its exit code
      --script-socket           let other programs of this user run scripts, such as tools/python/robotui.py
      --for SECONDS             end by itself
      --screenshot FILE         save the window's picture ...
      --after SECONDS           ... this long after the start
      --theme light|dark        how the window looks
      --measure FILE            write every second how long the start and the display took
      --memory SIZE             how much memory robots and views may take, such as 4g (usually a quarter of the machine's, 2g at most);
                                the environment's ROBOTUI_MEMORY says the same
      --stay                    leave the simulated robot running at the end
  ./robotui stop                stop the robots of all running workbenches of this user, also where a window hangs; says what was stopped.
                                0: all stopped, 1: one does not answer, 4: none runs. A stop stays until it is released in a window
  ./robotui check CONFIG        print every connection made, refused, pending or ambiguous, and why
      --live                    ask the running robots what they have (else no robot is asked)
      --reuse md|csv            also print which bundles are used by which robot UI, as a table
  ./robotui words [TYPE...]     print what a configuration can say of a robot interface, a view or a robot UI (such as ros or map), and of safety, with
                                what is usual; without TYPE, which types there are.  --json  a JSON line for each
  ./robotui support [FILE]      write what somebody needs who helps into a zip that only you can read: logs, configurations, versions, threads of what
                                runs, with secrets masked; it says what is in it.  --config CONFIG  also this configuration
  ./robotui new --rfic TYPE --name NAME FILE   write the configuration of a robot from what it offers, and say why; FILE is new, or added to
      --set KEY=VALUE           a setting of its interface, such as host=keira (any number)
      --ruic TYPE  --views A,B  else what fits best;  --connect VIEW.PORT=PORT  where several ports fit, else the plainest
      --robot NAME  --wait SECONDS  --dry   print it only
  ./robotui install SITE [FEATURE...]   install features of an update site (an address or a folder); without FEATURE the only one that it offers,
                                else what it offers is printed. What runs takes it up without a restart
      --unsigned                do not ask before what nobody has signed is installed
  ./robotui install DIR|JAR     the bundles that were built in a folder, each time that they are built; or one jar
  ./robotui installed           print features and jars that can be removed
  ./robotui update [FEATURE...] install newer versions, from the sites that something was installed from;  --unsigned  as above
  ./robotui remove FEATURE|JAR...   remove features, or jars; settings stay
TEXT
}

help_end() {
  cat <<'TEXT'
  ./robotui --version           which RobotUI this is, and with which Java it runs
  ./robotui help                this text
TEXT
}

# cmd_version VERSION
cmd_version() {
  local home
  printf 'RobotUI %s\n' "$1"
  if home=$(find_java java); then
    printf 'Java %s in %s\n' "$(sed -n 's/^JAVA_VERSION="\(.*\)"/\1/p' "$home/release")" "$home"
  else
    printf 'no Java >= %s was found\n' "$JAVA_WANTED"
  fi
}
