package org.robotui.ros;

import java.util.Objects;

/**
 * A name in the ROS graph: global ({@code /a/b}), relative ({@code a/b}) or private ({@code ~a}). It holds letters,
 * digits, underscores and slashes and starts with a letter, {@code /} or {@code ~}. Global names are those that a
 * master hands out, and some nodes register names that ROS only warns of: a global name may hold all visible ASCII
 * characters but {@code ~}. Repeated and trailing slashes are removed.
 *
 * @param text the name as it is written
 */
public record GraphName(String text) implements Comparable<GraphName> {

  /** The root namespace. */
  public static final GraphName ROOT = new GraphName("/");

  /**
   * Checks and cleans the name.
   *
   * @throws InvalidNameException if the text is no name
   */
  public GraphName {
    check(Objects.requireNonNull(text, "text"));
    text = clean(text);
  }

  /**
   * The name with the given text.
   *
   * @param text the name as a user writes it
   * @return the name
   * @throws InvalidNameException if the text is no name
   */
  public static GraphName of(String text) {
    return new GraphName(text);
  }

  /**
   * A name that no other node has: the base followed by this process's id and the time.
   *
   * @param base a name of one part
   * @return the base with a unique ending
   * @throws InvalidNameException if the base is no name
   */
  public static GraphName anonymous(String base) {
    long unique = System.nanoTime() ^ java.util.concurrent.ThreadLocalRandom.current().nextInt(1 << 20);
    return of(base + "_" + ProcessHandle.current().pid() + "_" + Long.toUnsignedString(unique, 36));
  }

  /**
   * Whether the name starts at the root.
   *
   * @return true for {@code /a}
   */
  public boolean isGlobal() {
    return text.startsWith("/");
  }

  /**
   * Whether the name belongs to a node's private namespace.
   *
   * @return true for {@code ~a}
   */
  public boolean isPrivate() {
    return text.startsWith("~");
  }

  /**
   * The name of the namespace that holds this name.
   *
   * @return {@code /a} for {@code /a/b}, the root for {@code /a} and for the root itself
   * @throws IllegalStateException if this name is not global
   */
  public GraphName namespace() {
    requireGlobal();
    int slash = text.lastIndexOf('/');
    return slash <= 0 ? ROOT : new GraphName(text.substring(0, slash));
  }

  /**
   * A name below this one.
   *
   * @param relative a relative or private name; its {@code ~} is dropped
   * @return {@code /a/b} for {@code /a} and {@code b}
   */
  public GraphName join(GraphName relative) {
    String tail = relative.isPrivate() ? relative.text.substring(1) : relative.text;
    return tail.isEmpty() ? this : new GraphName(text + "/" + tail);
  }

  /**
   * Whether a name is this one or lies below it.
   *
   * @param other a global name
   * @return true if this name is a namespace of the other, or the same
   */
  public boolean contains(GraphName other) {
    return equals(other) || other.text.startsWith(text.endsWith("/") ? text : text + "/");
  }

  @Override
  public int compareTo(GraphName other) {
    return text.compareTo(other.text);
  }

  @Override
  public String toString() {
    return text;
  }

  private void requireGlobal() {
    if (!isGlobal()) {
      throw new IllegalStateException("'" + text + "' is not a global name");
    }
  }

  private static void check(String text) {
    if (text.isEmpty()) {
      throw new InvalidNameException(text, "it is empty");
    }
    if (!isLetter(text.charAt(0)) && text.charAt(0) != '/' && text.charAt(0) != '~') {
      throw new InvalidNameException(text, "it must start with a letter, '/' or '~'");
    }
    boolean global = text.charAt(0) == '/';
    for (int i = 1; i < text.length(); i++) {
      checkFollowing(text, i, global);
    }
  }

  private static void checkFollowing(String text, int index, boolean global) {
    char c = text.charAt(index);
    if (global && (c <= ' ' || c >= '~')) {
      throw new InvalidNameException(text, "'" + c + "' at position " + (index + 1)
          + "; only visible ASCII characters other than '~' may follow");
    }
    if (!global && !isLetter(c) && !(c >= '0' && c <= '9') && c != '_' && c != '/') {
      throw new InvalidNameException(text, "'" + c + "' at position " + (index + 1)
          + "; only letters, digits, '_' and '/' may follow");
    }
  }

  private static boolean isLetter(char c) {
    return c >= 'a' && c <= 'z' || c >= 'A' && c <= 'Z';
  }

  private static String clean(String text) {
    String single = text.replaceAll("/{2,}", "/").replaceFirst("^~/", "~");
    return single.length() > 1 && single.endsWith("/") ? single.substring(0, single.length() - 1) : single;
  }
}
