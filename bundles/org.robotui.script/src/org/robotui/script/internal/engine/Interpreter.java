package org.robotui.script.internal.engine;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mozilla.javascript.BaseFunction;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.RhinoException;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Undefined;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptOutcome.Done;
import org.robotui.api.script.ScriptOutcome.Exited;
import org.robotui.api.script.ScriptOutcome.Failed;
import org.robotui.api.script.ScriptOutcome.Stopped;

/** The variables of a session, and running a script with them. On the thread of the session only. */
final class Interpreter {
  private final Sandbox sandbox = new Sandbox();
  private final Surroundings surroundings;
  private Optional<ScriptableObject> objects = Optional.empty();
  private Optional<Scriptable> variables = Optional.empty();

  Interpreter(Surroundings surroundings) {
    this.surroundings = surroundings;
  }

  ScriptOutcome run(ScriptRun run, List<ScriptFunction> functions) {
    Context context = sandbox.enterContext();
    try {
      Sandbox.belongsTo(context, run);
      Scriptable scope = scope(context, functions);
      run.waited(); // what the engine took for its own beginning
      return done(context, scope,
          context.evaluateString(scope, run.source().text(), run.source().name(), 1, null));
    } catch (ExitWish e) {
      return new Exited(e.code());
    } catch (Halt e) {
      return new Stopped(e.getMessage(), run.source().name(), e.place().line());
    } catch (RhinoException e) {
      Place place = Place.of(e);
      return new Failed(reason(e), place.source(), place.line());
    } catch (ScriptFailure e) {
      return new Failed(e.getMessage(), run.source().name(), 0);
    } catch (StackOverflowError e) {
      return new Failed("calls or brackets lie too deep within each other", run.source().name(), 0);
    } catch (OutOfMemoryError e) {
      return new Failed("it needs more memory than there is", run.source().name(), 0);
    } finally {
      Context.exit();
    }
  }

  private static String reason(RhinoException thrown) {
    String details = String.valueOf(thrown.details());
    return details.startsWith("Error: ") ? details.substring("Error: ".length()) : details;
  }

  /** Variables are the session's own; what we give lies behind them, so that a script can use our names for its own. */
  private Scriptable scope(Context context, List<ScriptFunction> functions) {
    ScriptableObject known = objects.orElseGet(() -> Sandbox.standardObjects(context));
    objects = Optional.of(known);
    give(known, functions);
    Scriptable scope = variables.orElseGet(() -> {
      Scriptable made = context.newObject(known);
      made.setPrototype(known);
      made.setParentScope(null);
      return made;
    });
    variables = Optional.of(scope);
    return scope;
  }

  /** Bundles come and go. */
  private void give(ScriptableObject known, List<ScriptFunction> functions) {
    Stream.of(known.getAllIds()).filter(String.class::isInstance).map(String.class::cast)
        .filter(name -> known.get(name, known) instanceof HostFunction f && !functions.contains(f.function()))
        .toList().forEach(known::delete);
    for (ScriptFunction function : functions) {
      if (!(known.get(function.name(), known) instanceof HostFunction)) {
        known.defineProperty(function.name(), new HostFunction(known, function, surroundings),
            ScriptableObject.DONTENUM);
      }
    }
  }

  private static ScriptOutcome done(Context context, Scriptable scope, Object value) throws ScriptFailure {
    if (value == null || Undefined.isUndefined(value)) {
      return new Done(Optional.empty(), value == null ? "null" : "");
    }
    if (value instanceof HostFunction ours) {
      return new Done(Optional.empty(), "function " + ours.function().signature());
    }
    if (value instanceof BaseFunction function) {
      return new Done(Optional.empty(), "function " + function.getFunctionName());
    }
    if (value instanceof CharSequence || value instanceof Scriptable || value instanceof Boolean
        || value instanceof Number) {
      Object plain = new FromScript(context, scope).of(value);
      return new Done(Optional.ofNullable(plain), PlainText.of(plain));
    }
    return new Done(Optional.empty(), ScriptRuntime.toString(value));
  }

  /** Their names. */
  Set<String> variables() {
    return variables.map(v -> Stream.of(v.getIds()).map(String::valueOf).collect(Collectors.toUnmodifiableSet()))
        .orElse(Set.of());
  }
}
