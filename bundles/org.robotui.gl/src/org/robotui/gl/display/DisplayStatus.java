package org.robotui.gl.display;

/** How a display is, and if nothing is seen: why. Each is shown differently. */
public sealed interface DisplayStatus {
  /**
   * A sentence for users.
   *
   * @return what is so, and what would help
   */
  String words();

  /**
   * Something is seen.
   *
   * @param words how much, for example {@code 541 points}; may be empty
   */
  record Shown(String words) implements DisplayStatus {}

  /**
   * Seen, but not as it should be: a mesh is missing, points are left out.
   *
   * @param words what is wrong and what would help
   */
  record Partly(String words) implements DisplayStatus {}

  /**
   * No source, or nothing came yet.
   *
   * @param words what is waited for
   */
  record NoData(String words) implements DisplayStatus {}

  /**
   * It is not known where the data lie.
   *
   * @param words names the missing link
   */
  record NoFrame(String words) implements DisplayStatus {}

  /**
   * The newest data are too old to be shown as if they were true.
   *
   * @param words how old
   */
  record TooOld(String words) implements DisplayStatus {}

  /**
   * The data cannot be shown so.
   *
   * @param words why: a field that is not there, a message that is broken
   */
  record Unfit(String words) implements DisplayStatus {}
}
