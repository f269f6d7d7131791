package org.robotui.core.internal.config;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.api.host.Problem;

/** A mistake in a template is one mistake, not one for each robot that is formed of it. */
final class Repeated {
  private static final Pattern FORMED = Pattern.compile("(.*) \\(for (.+)\\)", Pattern.DOTALL);

  private Repeated() {}

  /** What is said behind a message about a template. */
  static String of(String robot) {
    return robot.isEmpty() ? "" : " (for " + robot + ")";
  }

  /** What stands behind a message about a template, empty behind others. */
  static String behind(String message) {
    Matcher formed = FORMED.matcher(message);
    return formed.matches() ? of(formed.group(2)) : "";
  }

  /** What is the same but for the robot: message and place, the robot's name in it left open. */
  private record Kind(String file, int line, int column, String words) {}

  /** The same problems, each once, in their order. */
  static List<Problem> merged(List<Problem> problems) {
    Map<Kind, List<Problem>> kinds = new LinkedHashMap<>();
    problems.forEach(p -> kinds.computeIfAbsent(kind(p), k -> new ArrayList<>()).add(p));
    return kinds.entrySet().stream().flatMap(e -> of(e.getKey(), e.getValue()).stream()).toList();
  }

  private static Kind kind(Problem p) {
    Matcher formed = FORMED.matcher(p.message());
    String words = formed.matches() ? formed.group(1).replace(formed.group(2), ForNames.ROBOT) : p.message();
    return new Kind(p.file(), p.line(), p.column(), words);
  }

  private static List<Problem> of(Kind kind, List<Problem> same) {
    Problem first = same.getFirst();
    if (same.size() == 1 || behind(first.message()).isEmpty()) {
      return same;
    }
    String message =
        first.message().substring(0, first.message().length() - 1) + " and " + (same.size() - 1) + " more)";
    return List.of(new Problem(kind.file(), kind.line(), kind.column(), first.severity(), message));
  }
}
