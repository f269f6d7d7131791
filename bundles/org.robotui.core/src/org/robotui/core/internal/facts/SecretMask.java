package org.robotui.core.internal.facts;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Takes out of a text what must not be given away: values of settings and parameters whose names say that they are
 * secret, names and passwords in addresses, keys. No setting of RobotUI itself is a secret; those of others (addresses
 * of bridges with a token, parameters of robots, what their programs log) may be.
 */
final class SecretMask {
  /** What stands in place of a secret. */
  static final String MASK = "***";

  private static final String WORDS =
      "passw(?:or)?d|passwd|passphrase|passcode|pwd|secret|token|credential|authorization|cookie|psk"
          + "|(?:api|access|private|auth|signing|encryption|secret|license)[_.-]?key";
  private static final String NAME = "[\\w.-]{0,200}?(?:" + WORDS + ")[\\w.-]{0,200}";
  /** {@code password: value} or {@code password=value} that begins a line, alone or as the first of a list's item. */
  private static final Pattern WHOLE_LINE =
      Pattern.compile("^(\\s*(?:-\\s+)*)([\"']?(?:" + NAME + "|pass)[\"']?\\s*[:=])(?![/:])(.*)$",
          Pattern.CASE_INSENSITIVE);
  /** The same within a line; a line of a class in the stack of an exception is none. */
  private static final Pattern WITHIN = Pattern.compile("((?<![\\w.-])[\"']?" + NAME
      + "(?<![.]java)[\"']?\\s*[:=]\\s*)(\"(?:[^\"\\\\]|\\\\.){0,1000}\"?|'[^']*'?|[^\\s,;&}\\])\"']+)",
      Pattern.CASE_INSENSITIVE);
  private static final Pattern QUERY =
      Pattern.compile("([?&](?:key|sig|signature|auth|code|pass)=)[^\\s&\"']+", Pattern.CASE_INSENSITIVE);
  private static final Pattern USER =
      Pattern.compile("((?<![a-z0-9+.-])[a-z][a-z0-9+.-]{0,30}://)[^\\s/@\"'<>]+@", Pattern.CASE_INSENSITIVE);
  private static final Pattern BEARER =
      Pattern.compile("\\b(Bearer|Basic)\\s+[A-Za-z0-9._~+/=-]{8,}", Pattern.CASE_INSENSITIVE);
  private static final Pattern KEY_BEGINS = Pattern.compile("-----BEGIN [A-Z0-9 ]*PRIVATE KEY-----");
  private static final Pattern KEY_ENDS = Pattern.compile("-----END [A-Z0-9 ]*PRIVATE KEY-----");

  /** What programs of robots log is looked through as well, and must not take for ever. */
  private static final int LONGEST_LINE = 10_000;

  private boolean inKey;
  /** How far the name of a secret is indented whose value goes on below it; -1 for none. */
  private int below = -1;

  private SecretMask() {}

  /** A text without its secrets; as many lines. */
  static String masked(String text) {
    SecretMask mask = new SecretMask();
    StringBuilder out = new StringBuilder(text.length());
    text.lines().forEach(line -> out.append(mask.next(line)).append('\n'));
    return out.toString();
  }

  private String next(String whole) {
    String line = whole.length() > LONGEST_LINE ? whole.substring(0, LONGEST_LINE) + " (cut)" : whole;
    return key(line).or(() -> under(line)).or(() -> whole(line)).orElseGet(() -> within(line));
  }

  private Optional<String> key(String line) {
    boolean secret = inKey || KEY_BEGINS.matcher(line).find();
    inKey = secret && !KEY_ENDS.matcher(line).find();
    return secret ? Optional.of(MASK) : Optional.empty();
  }

  /** Lines of a value that are indented further than its name belong to it. */
  private Optional<String> under(String line) {
    boolean secret = below >= 0 && (line.isBlank() || indent(line) > below);
    below = secret ? below : -1;
    return secret ? Optional.of(line.isBlank() ? line : " ".repeat(indent(line)) + MASK) : Optional.empty();
  }

  private Optional<String> whole(String line) {
    Matcher matcher = WHOLE_LINE.matcher(line);
    if (!matcher.matches()) {
      return Optional.empty();
    }
    below = matcher.group(1).length();
    String value = matcher.group(3).isBlank() ? "" : " " + MASK;
    return Optional.of(matcher.group(1) + matcher.group(2) + value);
  }

  private static String within(String line) {
    String text = BEARER.matcher(line).replaceAll("$1 " + MASK);
    if (text.indexOf('=') < 0 && text.indexOf(':') < 0) {
      return text; // the others need one of them, and take long to find that out of a long line
    }
    text = USER.matcher(text).replaceAll("$1" + MASK + "@");
    text = QUERY.matcher(text).replaceAll("$1" + MASK);
    return WITHIN.matcher(text).replaceAll("$1" + MASK);
  }

  private static int indent(String line) {
    return line.length() - line.stripLeading().length();
  }
}
