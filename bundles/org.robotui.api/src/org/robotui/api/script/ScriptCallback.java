package org.robotui.api.script;

/**
 * A function of the script, given to one of ours. To be called on the thread of the script only, before ours returns.
 */
@FunctionalInterface
public interface ScriptCallback {
  /**
   * Calls it. What it throws ends the call of our function as well.
   *
   * @param arguments plain values or data of robots
   * @return a plain value
   */
  Object call(Object... arguments);
}
