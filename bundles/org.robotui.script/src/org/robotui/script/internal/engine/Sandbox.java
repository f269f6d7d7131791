package org.robotui.script.internal.engine;

import java.util.Optional;
import org.mozilla.javascript.Callable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.ContextFactory;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.WrapFactory;

/**
 * The engine, closed: a script sees no class and no object of Java, and is asked again and again whether it may go on.
 * It is interpreted, since only then does the engine know at every point where it is, and needs no stack of ours for
 * calls within the script.
 */
final class Sandbox extends ContextFactory {
  private static final Object RUN = new Object();
  private static final int INSTRUCTIONS = 20_000;

  @Override
  protected Context makeContext() {
    Context made = super.makeContext();
    made.setLanguageVersion(Context.VERSION_ES6);
    made.setInterpretedMode(true);
    made.setMaximumInterpreterStackDepth(ScriptLimits.DEPTH);
    made.setClassShutter(name -> false);
    made.setWrapFactory(new NoWrapping());
    made.setInstructionObserverThreshold(INSTRUCTIONS);
    return made;
  }

  @Override
  protected boolean hasFeature(Context context, int feature) {
    return switch (feature) {
      case Context.FEATURE_ENHANCED_JAVA_ACCESS, Context.FEATURE_E4X, Context.FEATURE_JAVA_SERIALIZATION -> false;
      default -> super.hasFeature(context, feature);
    };
  }

  @Override
  protected void observeInstructionCount(Context context, int count) {
    run(context).ifPresent(ScriptRun::check);
  }

  /** Says whose time passes in this context. */
  static void belongsTo(Context context, ScriptRun run) {
    context.putThreadLocal(RUN, run);
  }

  static Optional<ScriptRun> run(Context context) {
    return Optional.ofNullable(context.getThreadLocal(RUN)).map(ScriptRun.class::cast);
  }

  /** The objects of the language, without what would make texts of any length at one stroke. */
  static ScriptableObject standardObjects(Context context) {
    ScriptableObject objects = context.initSafeStandardObjects();
    Scriptable text = (Scriptable) ScriptableObject.getProperty(
        (Scriptable) ScriptableObject.getProperty(objects, "String"), "prototype");
    for (String name : new String[]{"repeat", "padStart", "padEnd"}) {
      Callable usual = (Callable) ScriptableObject.getProperty(text, name);
      ScriptableObject.putProperty(text, name, new BoundedText(objects, name, usual));
    }
    return objects;
  }

  /** Nothing of Java is ever shown to a script: what gets here by mistake is a text. */
  private static final class NoWrapping extends WrapFactory {
    @Override
    public Object wrap(Context context, Scriptable scope, Object value, Class<?> type) {
      return value == null || value instanceof Scriptable || value instanceof Boolean || value instanceof Number
          || value instanceof CharSequence ? value : String.valueOf(value);
    }
  }
}
