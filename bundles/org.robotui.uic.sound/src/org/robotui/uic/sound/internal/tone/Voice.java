package org.robotui.uic.sound.internal.tone;

/** Speaks. */
public interface Voice {
  /**
   * Speaks to the end. Blocks.
   *
   * @param words a few words
   * @throws SilentException where nothing can be heard; the message says why
   * @throws InterruptedException when the view ends
   */
  void say(String words) throws SilentException, InterruptedException;
}
