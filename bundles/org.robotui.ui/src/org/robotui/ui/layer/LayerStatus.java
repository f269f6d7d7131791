package org.robotui.ui.layer;

/** How a layer is, as far as only it can know; its view says by itself where no data came, or where they are old. */
public sealed interface LayerStatus {
  /**
   * A sentence for users.
   *
   * @return what is so, and what would help; may be empty
   */
  String words();

  /**
   * All is well.
   *
   * @param words how much is seen, for example {@code 541 echoes}; may be empty
   */
  record Shown(String words) implements LayerStatus {}

  /**
   * Seen, but not as it should be: a part has no transform, points are left out.
   *
   * @param words what is wrong and what would help
   */
  record Partly(String words) implements LayerStatus {}

  /**
   * Nothing came yet that could be shown.
   *
   * @param words what is waited for
   */
  record NoData(String words) implements LayerStatus {}

  /**
   * It is not known where the data lie. What was painted last goes on being shown for a second.
   *
   * @param words names the missing link
   */
  record NoFrame(String words) implements LayerStatus {}

  /**
   * The data cannot be shown so.
   *
   * @param words why: a field that is not there, a value that is broken
   */
  record Unfit(String words) implements LayerStatus {}
}
