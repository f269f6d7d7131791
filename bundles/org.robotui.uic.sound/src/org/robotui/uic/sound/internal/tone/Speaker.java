package org.robotui.uic.sound.internal.tone;

/** Plays sounds. */
public interface Speaker {
  /**
   * Plays to the end. Blocks.
   *
   * @param sound what to play
   * @param volume 0 to 1
   * @throws SilentException where nothing can be heard; the message says why
   * @throws InterruptedException when the view ends; the sound ends with it
   */
  void play(Pcm sound, double volume) throws SilentException, InterruptedException;
}
