package org.robotui.api.script;

import java.util.List;

/**
 * A function that scripts can call. Immutable and safe for all threads.
 *
 * @param name as scripts write it, for example {@code takeControl}; unique among all functions
 * @param parameters in their order; optional ones stand last
 * @param help a sentence for users: what it does
 * @param returns what it gives, in a few words; empty where it gives nothing
 * @param body does it
 */
public record ScriptFunction(String name, List<Parameter> parameters, String help, String returns, Body body) {
  /**
   * A parameter.
   *
   * @param name as users read it
   * @param optional whether it may be left out
   */
  public record Parameter(String name, boolean optional) {}

  /** What a function does. */
  @FunctionalInterface
  public interface Body {
    /**
     * Does it, on the thread of the script, which may be blocked: it is interrupted where the script is stopped.
     *
     * @param call its arguments, and what the script may use
     * @return a plain value, data of a robot, or null for nothing
     * @throws ScriptFailure where it cannot be done; the script can catch that
     * @throws InterruptedException where the script is stopped
     */
    Object call(ScriptCall call) throws ScriptFailure, InterruptedException;
  }

  /**
   * Copies the list and checks the name.
   *
   * @param name as scripts write it
   * @param parameters in their order
   * @param help a sentence
   * @param returns what it gives
   * @param body does it
   * @throws IllegalArgumentException where the name is no identifier, or a parameter that is needed follows one that
   * may be left out
   */
  public ScriptFunction {
    parameters = List.copyOf(parameters);
    if (!name.matches("[A-Za-z][A-Za-z0-9]{0,59}")) {
      throw new IllegalArgumentException("'" + name + "' is no name of a function: letters and digits, at most 60");
    }
    for (int i = 1; i < parameters.size(); i++) {
      if (parameters.get(i - 1).optional() && !parameters.get(i).optional()) {
        throw new IllegalArgumentException(
            name + ": the parameter " + parameters.get(i).name() + " must be optional as well");
      }
    }
  }

  /**
   * A function of which the signature is written as users read it.
   *
   * @param signature for example {@code drive(forward, turn, seconds, port?)}; a question mark says that a parameter
   * may be left out
   * @param help a sentence
   * @param returns what it gives
   * @param body does it
   * @return the function
   * @throws IllegalArgumentException where the signature is none
   */
  public static ScriptFunction of(String signature, String help, String returns, Body body) {
    int open = signature.indexOf('(');
    if (open < 0 || !signature.endsWith(")")) {
      throw new IllegalArgumentException("'" + signature + "' is no signature, such as stop(robot?)");
    }
    String inner = signature.substring(open + 1, signature.length() - 1).strip();
    List<Parameter> parameters = inner.isEmpty() ? List.of()
        : List.of(inner.split("\\s*,\\s*")).stream()
            .map(word -> new Parameter(word.replace("?", ""), word.endsWith("?"))).toList();
    return new ScriptFunction(signature.substring(0, open), parameters, help, returns, body);
  }

  /**
   * How it is called.
   *
   * @return for example {@code drive(forward, turn, seconds, port?)}
   */
  public String signature() {
    return name + "("
        + String.join(", ", parameters.stream().map(p -> p.optional() ? p.name() + "?" : p.name()).toList()) + ")";
  }

  /**
   * How many arguments it needs.
   *
   * @return the count of parameters that cannot be left out
   */
  public int needed() {
    return (int) parameters.stream().filter(p -> !p.optional()).count();
  }
}
