package org.robotui.script.internal.engine;

import org.mozilla.javascript.BaseFunction;
import org.mozilla.javascript.Callable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;

/** A function of texts that makes a longer one of a given size: one that would not fit into the memory is refused. */
final class BoundedText extends BaseFunction {
  private static final long serialVersionUID = 1L;

  private final String name;
  private final transient Callable usual;

  BoundedText(Scriptable scope, String name, Callable usual) {
    super(scope, ((Scriptable) usual).getPrototype());
    this.name = name;
    this.usual = usual;
  }

  @Override
  public Object call(Context context, Scriptable scope, Scriptable self, Object[] arguments) {
    double size = arguments.length == 0 ? 0 : ScriptRuntime.toNumber(arguments[0]);
    double length = name.equals("repeat") ? size * ScriptRuntime.toString(self).length() : size;
    if (length > ScriptLimits.LONGEST_TEXT) {
      throw ScriptRuntime.constructError("RangeError",
          name + " would make a text of more than " + ScriptLimits.LONGEST_TEXT + " characters");
    }
    return usual.call(context, scope, self, arguments);
  }

  @Override
  public String getFunctionName() {
    return name;
  }
}
