package org.robotui.recorder.internal.capture;

import java.util.List;
import java.util.regex.Pattern;

/**
 * Names with {@code *}, {@code ?} and <code>{a,b}</code>, of which none stands for all.
 *
 * @param patterns as regular expressions
 */
public record NamePatterns(List<Pattern> patterns) {
  /** As users write them. */
  public static NamePatterns of(List<String> written) {
    return new NamePatterns(written.stream().map(NamePatterns::pattern).toList());
  }

  private static Pattern pattern(String written) {
    StringBuilder regex = new StringBuilder();
    int open = 0;
    for (char c : written.toCharArray()) {
      switch (c) {
        case '*' -> regex.append(".*");
        case '?' -> regex.append('.');
        case '{' -> {
          open++;
          regex.append("(?:");
        }
        case '}' -> regex.append(open-- > 0 ? ")" : "\\}");
        case ',' -> regex.append(open > 0 ? "|" : ",");
        default -> regex.append(Pattern.quote(String.valueOf(c)));
      }
    }
    return Pattern.compile(regex.append(")".repeat(Math.max(0, open))).toString());
  }

  /** Whether one of some names is meant. */
  public boolean mean(String... names) {
    return patterns.isEmpty() || List.of(names).stream()
        .anyMatch(name -> patterns.stream().anyMatch(pattern -> pattern.matcher(name).matches()));
  }
}
