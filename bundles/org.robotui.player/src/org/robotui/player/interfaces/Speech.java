package org.robotui.player.interfaces;

import org.robotui.player.layout.Kind;

/** Speech synthesis. The interface {@code speech}. */
public final class Speech {

  /** Command: say. */
  public static final Kind.Command<Text> SAY = new Kind.Command<>("speech", "say", Text.class);

  private Speech() {}

  /**
   * What to say.
   *
   * @param text the words
   */
  public record Text(String text) {}
}
