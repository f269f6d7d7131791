package org.robotui.message;

/** Bytes that are no message of the expected type: says what is wrong and where. */
public final class MessageException extends Exception {

  private static final long serialVersionUID = 1L;

  private final String problem;
  private final String path;
  private final long offset;

  /**
   * Creates the error for one place in a message.
   *
   * @param problem what is wrong, for a user to read
   * @param path the field, such as {@code header.frame_id} or {@code points[3].x}; empty for the message itself
   * @param offset the byte offset within the message
   */
  public MessageException(String problem, String path, long offset) {
    super(problem + (path.isEmpty() ? "" : " in field " + path) + " at byte " + offset);
    this.problem = problem;
    this.path = path;
    this.offset = offset;
  }

  /**
   * The same error seen from the message that holds the failing field.
   *
   * @param outer the name of the field that holds this one
   * @return an error whose path starts with {@code outer}
   */
  public MessageException within(String outer) {
    String joined = path.isEmpty() ? outer : path.startsWith("[") ? outer + path : outer + "." + path;
    MessageException wrapped = new MessageException(problem, joined, offset);
    wrapped.initCause(this);
    return wrapped;
  }

  /**
   * What is wrong, without the place.
   *
   * @return a sentence without a full stop
   */
  public String problem() {
    return problem;
  }

  /**
   * The failing field.
   *
   * @return field names joined by dots, indices in brackets; empty for the message itself
   */
  public String path() {
    return path;
  }

  /**
   * Where the failing field starts.
   *
   * @return the byte offset within the message
   */
  public long offset() {
    return offset;
  }
}
