package org.robotui.roboframe.board;

/**
 * Writes a key.
 *
 * @param <T> its values
 */
public interface KeyOutput<T> extends KeyUse {

  /**
   * Puts a value onto the blackboard, and hands it to all who read it; never waits for any of them.
   *
   * @param value nobody changes it afterwards
   */
  void push(T value);

  /**
   * How many read it now.
   *
   * @return modules here, and other applications
   */
  int readers();
}
