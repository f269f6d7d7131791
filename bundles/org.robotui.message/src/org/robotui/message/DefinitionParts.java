package org.robotui.message;

import java.util.ArrayList;
import java.util.List;

/** The parts of definitions of services and actions, which lines of dashes separate. */
final class DefinitionParts {

  private DefinitionParts() {}

  static List<String> of(String text) {
    List<String> parts = new ArrayList<>();
    StringBuilder part = new StringBuilder();
    for (String line : text.split("\n", -1)) {
      if (line.startsWith("---")) {
        parts.add(part.toString());
        part.setLength(0);
      } else {
        part.append(line).append('\n');
      }
    }
    parts.add(part.toString());
    return parts;
  }
}
