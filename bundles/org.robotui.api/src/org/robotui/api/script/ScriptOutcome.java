package org.robotui.api.script;

import java.util.Optional;

/** How a script ended. */
public sealed interface ScriptOutcome {
  /**
   * It came to its end.
   *
   * @param value of its last expression: a plain value; none where it has none
   * @param text the value as users read it; empty where there is none
   */
  record Done(Optional<Object> value, String text) implements ScriptOutcome {}

  /**
   * It asked for the end with {@code exit(code)}.
   *
   * @param code for who started it; 0 is fine, at most 20
   */
  record Exited(int code) implements ScriptOutcome {}

  /**
   * Something went wrong.
   *
   * @param reason a sentence for users
   * @param source name of the script, empty where it is not known
   * @param line from 1, 0 where it is not known
   */
  record Failed(String reason, String source, int line) implements ScriptOutcome {
    @Override
    public String toString() {
      return (source.isEmpty() ? "" : source + (line > 0 ? ":" + line : "") + ": ") + reason;
    }
  }

  /**
   * It was stopped from outside.
   *
   * @param reason a sentence for users
   * @param source name of the script
   * @param line where it was, from 1; 0 where it is not known
   */
  record Stopped(String reason, String source, int line) implements ScriptOutcome {
    @Override
    public String toString() {
      return source + (line > 0 ? ":" + line : "") + ": " + reason;
    }
  }
}
