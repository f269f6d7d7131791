package org.robotui.script.internal.engine;

/**
 * Ends a script from outside. It is an error, since a script can catch and finally undo everything else.
 */
final class Halt extends Error {
  private static final long serialVersionUID = 1L;

  private final transient Place place;

  Halt(String reason, Place place) {
    super(reason, null, false, false);
    this.place = place;
  }

  Place place() {
    return place;
  }
}
