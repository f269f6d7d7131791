package org.robotui.rfic.recording.internal.tool;

/** A command that cannot be understood; the message says what is wrong with it. */
final class UsageException extends Exception {

  private static final long serialVersionUID = 1L;

  UsageException(String sentence) {
    super(sentence);
  }
}
