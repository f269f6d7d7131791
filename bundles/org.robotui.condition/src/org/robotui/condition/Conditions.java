package org.robotui.condition;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.input.Numerals;
import org.robotui.data.record.FieldPath;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.Severity;

/** Reads conditions as they are written in a configuration. */
public final class Conditions {
  private static final String FORMS =
      "'battery charge < 0.2', 'battery status changes', 'scan stale', 'link lost', 'diagnostics >= ERROR' or 'log >= ERROR'";
  private static final String CHANGES = "changes";
  private static final int FIELD_WORDS = 4;
  private static final int LEVEL_WORDS = 3;

  private Conditions() {}

  /**
   * Reads a condition.
   *
   * @param text for example {@code battery charge < 0.2}, or several with {@code and}, {@code or}, {@code not},
   * brackets, arithmetic, {@code age(scan)}, {@code rate(scan)} and {@code delay(scan)}
   * @param slack hysteresis of numbers, not negative
   * @return the condition
   * @throws IllegalArgumentException where it cannot be read; the message says what is wrong and what could be written
   */
  public static Condition parse(String text, double slack) {
    ConditionWords pieces = new ConditionWords(text);
    if (pieces.combine()) {
      return new ExpressionCondition(new ConditionParser(pieces).parse(), slack);
    }
    List<String> words = words(pieces);
    Optional<Comparison> sign = words.stream().map(Comparison::find).flatMap(Optional::stream).findFirst();
    if (sign.isEmpty()) {
      return state(text, words);
    }
    int at = words.indexOf(sign.get().sign());
    String first = words.getFirst().toLowerCase(Locale.ROOT);
    boolean level =
        (first.equals("diagnostics") || first.equals("log")) && (at == 1 || levelOf(first, words.getLast()));
    if (level && at >= 1 && at <= 2 && words.size() == at + 2) {
      return level(text, words, at, sign.get());
    }
    if (at == 2 && words.size() == FIELD_WORDS) {
      return field(words, sign.get(), slack);
    }
    throw new IllegalArgumentException(
        "'" + text + "' cannot be read; write a source, a field, a comparison and a value, for example " + FORMS);
  }

  /** Whether a word is a level of diagnostics. */
  static boolean isLevel(String word) {
    return find(Diagnostics.Level.class, word).isPresent();
  }

  private static Condition state(String text, List<String> words) {
    if (words.equals(List.of("link", "lost"))) {
      return new LinkCondition();
    }
    if (words.size() == 2 && words.getLast().equals("stale")) {
      return new StaleCondition(new SourceName(words.getFirst()));
    }
    if (words.size() >= 2 && words.size() <= LEVEL_WORDS && words.getLast().equals(CHANGES)) {
      return change(text, words);
    }
    throw new IllegalArgumentException("'" + text + "' is no condition; write for example " + FORMS);
  }

  private static Condition change(String text, List<String> words) {
    boolean field = words.size() == LEVEL_WORDS;
    if (words.getFirst().equals("diagnostics")) {
      return new LevelChangeCondition(field ? words.get(1) : "");
    }
    if (!field) {
      throw new IllegalArgumentException(
          "'" + text + "': behind a source its field is missing; write for example 'battery status changes'");
    }
    return new ChangeCondition(new SourceName(words.getFirst()), FieldPath.parse(words.get(1)));
  }

  private static Condition field(List<String> words, Comparison sign, double slack) {
    String limit = words.getLast();
    if (sign.ordered() && Numerals.decimal(limit).isEmpty()) {
      throw new IllegalArgumentException(
          "'" + limit + "' is no number; after " + sign.sign() + " write one, or compare by == or !=");
    }
    return new FieldCondition(new SourceName(words.getFirst()), FieldPath.parse(words.get(1)), sign, limit, slack);
  }

  private static Condition level(String text, List<String> words, int at, Comparison sign) {
    String part = at == LEVEL_WORDS - 1 ? words.get(1) : "";
    boolean log = words.getFirst().equalsIgnoreCase("log");
    return log
        ? new LogCondition(part, sign, constant(Severity.class, text, words.getLast()))
        : new DiagnosticsCondition(part, sign, constant(Diagnostics.Level.class, text, words.getLast()));
  }

  private static boolean levelOf(String kind, String word) {
    return kind.equals("log") ? find(Severity.class, word).isPresent()
        : isLevel(word);
  }

  private static <E extends Enum<E>> E constant(Class<E> type, String text, String word) {
    return find(type, word).orElseThrow(() -> new IllegalArgumentException("'" + text + "': '" + word + "' is none of "
        + Arrays.stream(type.getEnumConstants()).map(Enum::name).collect(Collectors.joining(", "))));
  }

  private static <E extends Enum<E>> Optional<E> find(Class<E> type, String word) {
    String name = word.equalsIgnoreCase("WARN") ? "WARNING" : word.toUpperCase(Locale.ROOT);
    return Arrays.stream(type.getEnumConstants()).filter(each -> each.name().equals(name)).findFirst();
  }

  private static List<String> words(ConditionWords pieces) {
    List<String> words = pieces.texts();
    if (!words.isEmpty() && words.getFirst().endsWith(":")) {
      words.set(0, words.getFirst().substring(0, words.getFirst().length() - 1));
    }
    return words;
  }
}
