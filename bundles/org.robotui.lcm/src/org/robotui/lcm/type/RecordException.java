package org.robotui.lcm.type;

/** Bytes that are no message of the expected type: says of which type, what is wrong and where. */
public final class RecordException extends Exception {

  private static final long serialVersionUID = 1L;

  private final String type;
  private final String problem;
  private final String path;
  private final int offset;

  /**
   * Creates the error for one place in a message.
   *
   * @param type the type that was expected
   * @param problem what is wrong
   * @param path the member, such as {@code poses[3].x}; empty for the message itself
   * @param offset the byte within the message
   */
  public RecordException(String type, String problem, String path, int offset) {
    super(type + ": " + problem + (path.isEmpty() ? "" : ", in member " + path) + ", at byte " + offset);
    this.type = type;
    this.problem = problem;
    this.path = path;
    this.offset = offset;
  }

  /** The same error seen from the struct that holds the failing one. */
  RecordException within(String outer, String outerType) {
    String joined = path.isEmpty() || path.startsWith("[") ? outer + path : outer + "." + path;
    return new RecordException(outerType, problem, joined, offset);
  }

  /**
   * The type that was expected.
   *
   * @return its full name
   */
  public String type() {
    return type;
  }

  /**
   * What is wrong, without the place.
   *
   * @return a part of a sentence
   */
  public String problem() {
    return problem;
  }

  /**
   * The failing member.
   *
   * @return names joined by dots, indices in brackets; empty for the message itself
   */
  public String path() {
    return path;
  }

  /**
   * Where it is.
   *
   * @return the byte within the message
   */
  public int offset() {
    return offset;
  }
}
