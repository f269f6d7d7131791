package org.robotui.uic.parameters.internal.model;

import java.util.Optional;

/**
 * A row of the tree.
 *
 * @param key which one
 * @param depth how deep it lies
 * @param label the last part of its name
 * @param namespace whether something lies in it
 * @param open whether that is shown
 * @param leaves how many parameters lie in it
 * @param parameter whether it is a parameter
 * @param value its value, where known
 * @param text the value in one line, what is read or wrong where there is none
 * @param type the kind of the value
 * @param state how the value is doing
 * @param before what the value was when it was first read, where it changed since
 */
public record ParameterRow(
    Key key,
    int depth,
    String label,
    boolean namespace,
    boolean open,
    int leaves,
    boolean parameter,
    Optional<Object> value,
    String text,
    String type,
    State state,
    Optional<String> before) {
  /** How a value is doing. */
  public enum State {
    /** It is known. */
    KNOWN,
    /** It is being read or set. */
    BUSY,
    /** It changed since it was first read. */
    CHANGED,
    /** It could not be read or set. */
    WRONG
  }
}
