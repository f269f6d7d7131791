package org.robotui.api.host;

/**
 * A RUIC that is put together: its robot interface is tried, what it offers says which views fit, and the configuration
 * is written. The interface runs until this is closed; nothing is wired to it, and nothing is sent. Safe for all
 * threads.
 */
public interface Composition extends AutoCloseable {
  /**
   * What is known so far.
   *
   * @return as of now; never blocks
   */
  CompositionState state();

  /**
   * What would be written. Reads the file to which it would be added.
   *
   * @param draft what the user wants
   * @return the text, or why there is none; nothing is changed
   */
  CompositionText text(RuicDraft draft);

  /**
   * Writes. A reader sees either the former file or the new one; all that stands in a file stays, with its comments.
   *
   * @param draft what the user wants
   * @param shown what {@link #text} gave for it; where the file has changed since, nothing is written
   * @return what was written, or why nothing was
   */
  CompositionText write(RuicDraft draft, CompositionText.Text shown);

  /** Ends the robot interface. */
  @Override
  void close();
}
