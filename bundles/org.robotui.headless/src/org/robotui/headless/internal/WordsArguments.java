package org.robotui.headless.internal;

import java.util.ArrayList;
import java.util.List;
import org.robotui.headless.internal.Arguments.Wrong;

/**
 * Which words of configurations the command line asks for.
 *
 * @param types ids of types, or {@code safety}; none to list all types
 * @param json true for JSON lines, else text
 */
record WordsArguments(List<String> types, boolean json) {
  static final String OPTION = "-words";
  static final String USAGE = """
      -words [TYPE...]  print what configurations can say of these robot interfaces, views and robot UIs, and of safety; without TYPE list the types
        -json           a JSON line per setting
      """;

  static WordsArguments parse(List<String> words) throws Wrong {
    List<String> types = new ArrayList<>();
    boolean json = false;
    for (String word : words) {
      if (word.equals("-json")) {
        json = true;
      } else if (word.startsWith("-") && !word.equals(OPTION)) {
        throw new Wrong("unknown argument " + word);
      } else if (!word.equals(OPTION)) {
        types.add(word);
      }
    }
    return new WordsArguments(List.copyOf(types), json);
  }
}
