package org.robotui.roblets.body;

/** Hears of what comes into a bodymap. */
@FunctionalInterface
public interface BodyListener {
  /**
   * Something came, on the thread that brought it. It must not block.
   *
   * @param change what
   */
  void changed(BodyChange change);
}
