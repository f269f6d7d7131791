package org.robotui.core.internal.config;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.api.host.Problem;

/**
 * Replaces {@code ${NAME}} and {@code ${NAME:-fallback}} by environment variables; within a template {@code ${robot}}
 * and {@code ${number}} by those for whom it is formed.
 */
final class Variables {
  private static final Pattern VARIABLE = Pattern.compile("\\$\\{([A-Za-z_][A-Za-z0-9_]*)(?::-([^}]*))?}");

  private static final List<String> TEMPLATE = List.of("robot", "number");

  private final Map<String, String> environment;

  Variables(Map<String, String> environment) {
    this.environment = Map.copyOf(environment);
  }

  String replaceIn(String text, Map<String, String> words, Place place, List<Problem> problems) {
    return VARIABLE.matcher(text).replaceAll(m -> Matcher.quoteReplacement(value(m, words, place, problems)));
  }

  private String value(MatchResult variable, Map<String, String> words, Place place, List<Problem> problems) {
    String name = variable.group(1);
    return Optional.ofNullable(words.get(name))
        .or(() -> Optional.ofNullable(environment.get(name)))
        .or(() -> Optional.ofNullable(variable.group(2)))
        .orElseGet(() -> missing(name, place, problems));
  }

  private static String missing(String name, Place place, List<Problem> problems) {
    if (TEMPLATE.contains(name)) {
      problems.add(
          place.error("${" + name + "} stands for a name only in a section that says 'for:', such as  for: r1..r50"));
      return "";
    }
    problems.add(
        place.error(
            "the environment variable " + name + " is not set; set it, or write ${" + name + ":-a fallback}"));
    return "";
  }
}
