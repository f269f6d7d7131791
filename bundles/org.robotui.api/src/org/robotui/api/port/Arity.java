package org.robotui.api.port;

/** How many connections a port of a view takes. Ports of a robot interface serve any number. */
public enum Arity {
  /** None or one: the view works without. */
  OPTIONAL,
  /** One: without it the view has nothing to show. */
  ONE,
  /** Any number; a delivery names its source. */
  MANY
}
