package org.robotui.message.description;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The sum by which peers of ROS 2 compare types since Iron (REP 2011): that of the description of a type with all it
 * refers to, without comments, constants and defaults.
 *
 * @param text as peers announce it: {@code RIHS01_} and 64 lower-case hexadecimal digits
 */
public record TypeHash(String text) {

  private static final String PREFIX = "RIHS01_";
  private static final Pattern FORM = Pattern.compile(PREFIX + "[0-9a-f]{64}");
  private static final int SHOWN_DIGITS = 8;

  /**
   * Checks the form.
   *
   * @throws IllegalArgumentException if the text is no sum of version 1
   */
  public TypeHash {
    Objects.requireNonNull(text, "text");
    if (!FORM.matcher(text).matches()) {
      throw new IllegalArgumentException("'" + text + "' is no type hash: expected " + PREFIX + " and 64 digits");
    }
  }

  /**
   * Reads a sum.
   *
   * @param text what a peer announced
   * @return empty if it is no sum of version 1, or the one of 64 zeros, which stands for none
   */
  public static Optional<TypeHash> parse(String text) {
    boolean none = text.equals(PREFIX + "0".repeat(64));
    return !none && FORM.matcher(text).matches() ? Optional.of(new TypeHash(text)) : Optional.empty();
  }

  /**
   * Computes the sum of a type.
   *
   * @param description the type, with all it refers to
   * @return its sum
   */
  public static TypeHash of(TypeDescription description) {
    try {
      byte[] sum = MessageDigest.getInstance("SHA-256")
          .digest(CanonicalJson.of(description).getBytes(StandardCharsets.UTF_8));
      return new TypeHash(PREFIX + HexFormat.of().formatHex(sum));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
  }

  /**
   * The beginning of the sum, enough to tell two apart.
   *
   * @return eight digits
   */
  public String brief() {
    return text.substring(PREFIX.length(), PREFIX.length() + SHOWN_DIGITS);
  }

  @Override
  public String toString() {
    return text;
  }
}
