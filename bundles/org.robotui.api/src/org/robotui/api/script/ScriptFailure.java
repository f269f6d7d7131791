package org.robotui.api.script;

/** What a script asked for could not be done. The script can catch it; else it ends there. */
public final class ScriptFailure extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * A failure.
   *
   * @param sentence for users: what was refused, and what would help
   */
  public ScriptFailure(String sentence) {
    super(sentence);
  }
}
