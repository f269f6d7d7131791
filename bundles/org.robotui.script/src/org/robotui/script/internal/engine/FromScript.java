package org.robotui.script.internal.engine;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mozilla.javascript.Callable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.NativeArray;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Undefined;
import org.robotui.api.script.ScriptCallback;
import org.robotui.api.script.ScriptFailure;

/** Takes values of a script apart into plain ones, within bounds. Used for one value. */
final class FromScript {
  private final Context context;
  private final Scriptable scope;
  private int values;

  FromScript(Context context, Scriptable scope) {
    this.context = context;
    this.scope = scope;
  }

  Object of(Object value) throws ScriptFailure {
    return of(value, 0);
  }

  private Object of(Object value, int depth) throws ScriptFailure {
    if (++values > ScriptLimits.MOST_VALUES || depth > ScriptLimits.NESTING) {
      throw new ScriptFailure("the value is too large, or contains itself: at most " + ScriptLimits.MOST_VALUES
          + " values can be handed over, and " + ScriptLimits.NESTING + " within each other");
    }
    return switch (value) {
      case null -> null;
      case Undefined nothing -> null;
      case Boolean flag -> flag;
      case BigInteger whole -> whole.bitLength() < Long.SIZE ? (Object) whole.longValue() : whole.toString();
      case Number number -> number.doubleValue();
      case CharSequence text -> text(text);
      case Callable function -> callback(function);
      case NativeArray array -> list(array, depth);
      case Scriptable object -> wrapped(object, depth);
      default -> value.toString();
    };
  }

  private static String text(CharSequence text) throws ScriptFailure {
    if (text.length() > ScriptLimits.LONGEST_TEXT) {
      throw new ScriptFailure(
          "a text has " + text.length() + " characters; at most " + ScriptLimits.LONGEST_TEXT + " can be handed over");
    }
    return text.toString();
  }

  private List<Object> list(NativeArray array, int depth) throws ScriptFailure {
    if (array.getLength() > ScriptLimits.MOST_VALUES) {
      throw new ScriptFailure("an array has " + array.getLength() + " elements; at most " + ScriptLimits.MOST_VALUES
          + " can be handed over");
    }
    List<Object> items = new ArrayList<>();
    for (int i = 0; i < array.getLength(); i++) {
      items.add(of(ScriptableObject.getProperty(array, i) instanceof Object found
          && found != Scriptable.NOT_FOUND ? found : Undefined.instance, depth + 1));
    }
    return items;
  }

  /** Dates and the like are texts; anything else is its properties. */
  private Object wrapped(Scriptable object, int depth) throws ScriptFailure {
    return switch (object.getClassName()) {
      case "Date", "RegExp", "Error", "String", "Number", "Boolean", "Symbol" -> ScriptRuntime.toString(object);
      default -> map(object, depth);
    };
  }

  private Map<String, Object> map(Scriptable object, int depth) throws ScriptFailure {
    Map<String, Object> members = new LinkedHashMap<>();
    for (Object id : object.getIds()) {
      if (id instanceof String name) {
        members.put(name, of(ScriptableObject.getProperty(object, name), depth + 1));
      } else if (id instanceof Integer index) {
        members.put(index.toString(), of(ScriptableObject.getProperty(object, index), depth + 1));
      }
    }
    return members;
  }

  private ScriptCallback callback(Callable function) {
    return arguments -> {
      ToScript in = new ToScript(context, scope);
      Object[] given = new Object[arguments.length];
      for (int i = 0; i < given.length; i++) {
        given[i] = in.of(arguments[i]);
      }
      try {
        return new FromScript(context, scope).of(function.call(context, scope, scope, given));
      } catch (ScriptFailure e) {
        throw ScriptRuntime.constructError("Error", e.getMessage());
      }
    };
  }
}
