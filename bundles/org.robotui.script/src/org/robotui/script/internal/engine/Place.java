package org.robotui.script.internal.engine;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mozilla.javascript.EvaluatorException;
import org.mozilla.javascript.RhinoException;
import org.mozilla.javascript.ScriptStackElement;

/**
 * Where in a script.
 *
 * @param source its name, empty where it is not known
 * @param line from 1, 0 where it is not known
 */
record Place(String source, int line) {
  static final Place UNKNOWN = new Place("", 0);
  private static final Pattern MADE = Pattern.compile("(.*?)#(\\d{1,9})\\(.*");

  /** Where the script of this thread is now. */
  static Place now() {
    return of(new EvaluatorException("here"));
  }

  /** Where something was thrown: the innermost place that the engine knows. */
  static Place of(RhinoException thrown) {
    if (thrown.lineNumber() > 0 && thrown.sourceName() instanceof String name) {
      return outer(name, thrown.lineNumber());
    }
    ScriptStackElement[] stack = thrown.getScriptStack();
    return stack.length == 0 ? UNKNOWN : outer(stack[0].fileName, Math.max(0, stack[0].lineNumber));
  }

  /**
   * What a script makes itself, the engine calls {@code patrol.js#12(eval)}: to users that is the line of its maker.
   */
  private static Place outer(String name, int line) {
    Matcher made = MADE.matcher(name);
    return made.matches() ? new Place(made.group(1), Integer.parseInt(made.group(2))) : new Place(name, line);
  }
}
