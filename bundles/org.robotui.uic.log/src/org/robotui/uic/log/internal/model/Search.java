package org.robotui.uic.log.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;

/**
 * What is searched for. An expression that cannot be read, or that once took too long, searches nothing and says so:
 * all entries are shown then. Safe for all threads.
 */
public final class Search {
  /** Shows all. */
  public static final Search ALL = new Search("", false, Optional.empty(), "");

  private static final int STEPS = 50_000;
  private static final int STEPS_PER_CHARACTER = 20;
  private static final int MOST_SPANS = 64;

  /**
   * A part of a text that matches.
   *
   * @param start its first character
   * @param end the one after its last
   */
  public record Span(int start, int end) {}

  private final String text;
  private final boolean expression;
  private final Optional<Pattern> pattern;
  private volatile String problem;

  private Search(String text, boolean expression, Optional<Pattern> pattern, String problem) {
    this.text = text;
    this.expression = expression;
    this.pattern = pattern;
    this.problem = problem;
  }

  /** A search for words, or for a regular expression; capitals do not matter. */
  public static Search of(String text, boolean expression) {
    if (text.isEmpty()) {
      return expression ? new Search("", true, Optional.empty(), "") : ALL;
    }
    int flags = Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE;
    try {
      Pattern pattern = Pattern.compile(text, expression ? flags : flags | Pattern.LITERAL);
      return new Search(text, expression, Optional.of(pattern), "");
    } catch (PatternSyntaxException e) {
      return new Search(text, expression, Optional.empty(), reason(e));
    } catch (StackOverflowError e) {
      return new Search(text, expression, Optional.empty(), "the expression is nested too deeply");
    }
  }

  /** What is searched for, as written. */
  public String text() {
    return text;
  }

  /** Whether it is a regular expression. */
  public boolean expression() {
    return expression;
  }

  /** What is wrong with it, or empty. */
  public String problem() {
    return problem;
  }

  /** Whether it leaves entries out. */
  public boolean active() {
    return pattern.isPresent() && problem.isEmpty();
  }

  /** Whether an entry is shown: message, node or location match. */
  public boolean accepts(Entry entry) {
    return !active() || found(entry.message()) || found(entry.origin()) || found(entry.location()) || !active();
  }

  /** The parts of a text that match, the first few. */
  public List<Span> spans(String words) {
    List<Span> spans = new ArrayList<>();
    if (active()) {
      guarded(words, matcher -> {
        while (spans.size() < MOST_SPANS && matcher.find()) {
          if (matcher.end() > matcher.start()) {
            spans.add(new Span(matcher.start(), matcher.end()));
          }
        }
        return true;
      });
    }
    return List.copyOf(spans);
  }

  private boolean found(String words) {
    return guarded(words, Matcher::find);
  }

  private boolean guarded(String words, java.util.function.Predicate<Matcher> use) {
    try {
      return use.test(pattern.orElseThrow().matcher(new Metered(words, STEPS + STEPS_PER_CHARACTER * words.length())));
    } catch (TooSlowException e) {
      problem = "this expression takes too long on some entries; nothing is left out";
    } catch (StackOverflowError e) {
      // The expressions of the platform recurse over long texts.
      problem = "this expression is too complicated for some entries; nothing is left out";
    }
    return false;
  }

  private static String reason(PatternSyntaxException e) {
    String words = e.getDescription().toLowerCase(Locale.ROOT);
    return e.getIndex() < 0 ? words : words + " at character " + Math.min(e.getIndex() + 1, e.getPattern().length());
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Search s && s.text.equals(text) && s.expression == expression;
  }

  @Override
  public int hashCode() {
    return text.hashCode() + (expression ? 1 : 0);
  }
}
