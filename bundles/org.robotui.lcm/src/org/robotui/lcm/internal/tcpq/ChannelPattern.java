package org.robotui.lcm.internal.tcpq;

import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;

/** A regular expression that a client sent, with a bound on the work that it makes. */
final class ChannelPattern {

  private static final int MOST_STEPS = 100_000;

  private final String text;
  private final Pattern pattern;

  private ChannelPattern(String text, Pattern pattern) {
    this.text = text;
    this.pattern = pattern;
  }

  /** Reads an expression; one that is none is an argument error with its reason. */
  static ChannelPattern of(String text) {
    try {
      return new ChannelPattern(text, Pattern.compile(text));
    } catch (PatternSyntaxException | StackOverflowError e) {
      throw new IllegalArgumentException("'" + text + "' is no regular expression", e);
    }
  }

  String text() {
    return text;
  }

  /** Whether a channel matches; what takes more than its share of work does not. */
  boolean matches(String channel) {
    try {
      return pattern.matcher(new Metered(channel, new int[1])).matches();
    } catch (TooMuchWork | StackOverflowError e) {
      return false;
    }
  }

  /** Some expressions look at a text again and again, twice as often for each further character. */
  private static final class TooMuchWork extends RuntimeException {

    private static final long serialVersionUID = 1L;
  }

  /** A text that counts how often it is looked at. */
  private record Metered(CharSequence text, int[] steps) implements CharSequence {

    @Override
    public int length() {
      return text.length();
    }

    @Override
    public char charAt(int index) {
      if (++steps[0] > MOST_STEPS) {
        throw new TooMuchWork();
      }
      return text.charAt(index);
    }

    @Override
    public CharSequence subSequence(int start, int end) {
      return new Metered(text.subSequence(start, end), steps);
    }

    @Override
    public String toString() {
      return text.toString();
    }
  }
}
