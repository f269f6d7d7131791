package org.robotui.script.internal.engine;

import org.mozilla.javascript.BaseFunction;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.RhinoException;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.Undefined;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One of our functions as the script sees it. */
final class HostFunction extends BaseFunction {
  private static final long serialVersionUID = 1L;
  private static final Logger LOG = LoggerFactory.getLogger(HostFunction.class);

  private final transient ScriptFunction function;
  private final transient Surroundings surroundings;

  HostFunction(Scriptable scope, ScriptFunction function, Surroundings surroundings) {
    super(scope, getFunctionPrototype(scope));
    this.function = function;
    this.surroundings = surroundings;
  }

  ScriptFunction function() {
    return function;
  }

  @Override
  public Object call(Context context, Scriptable scope, Scriptable self, Object[] arguments) {
    ScriptRun run = Sandbox.run(context)
        .orElseThrow(() -> ScriptRuntime.constructError("Error", function.name() + " works only while a script runs"));
    run.check();
    try {
      Object given = function.body().call(called(context, run, arguments));
      return given == null ? Undefined.instance : new ToScript(context, getParentScope()).of(given);
    } catch (ScriptFailure e) {
      throw ScriptRuntime.constructError("Error", e.getMessage());
    } catch (InterruptedException e) {
      throw new Halt(run.stopped().orElse("it was interrupted"), Place.now());
    } catch (RhinoException e) {
      throw e; // of a function of the script that ours called
    } catch (RuntimeException e) {
      LOG.warn("The function {} of scripts failed", function.signature(), e);
      throw ScriptRuntime.constructError("Error", function.name() + " failed, which is a fault of its bundle: " + e);
    }
  }

  private CallArguments called(Context context, ScriptRun run, Object[] arguments) throws ScriptFailure {
    if (arguments.length < function.needed() || arguments.length > function.parameters().size()) {
      throw new ScriptFailure(
          "it is called " + function.signature() + ", and was given " + arguments.length + " argument"
              + (arguments.length == 1 ? "" : "s"));
    }
    Object[] plain = new Object[function.parameters().size()];
    for (int i = 0; i < arguments.length; i++) {
      plain[i] = new FromScript(context, getParentScope()).of(arguments[i]);
    }
    return new CallArguments(function, plain, surroundings, run);
  }

  @Override
  public String getFunctionName() {
    return function.name();
  }

  @Override
  public int getArity() {
    return function.parameters().size();
  }

  @Override
  public int getLength() {
    return function.needed();
  }

  @Override
  public Object getDefaultValue(Class<?> hint) {
    return "function " + function.signature();
  }
}
